package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.simulation.SessionInput
import robotran.simulation.state.SessionState
import robotran.world.Goal
import robotran.world.GoalCondition.Reach
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class RecordedRunTest {
    @Test
    fun `the repeated states are those of the run, with what a hand did in between`() = runTest {
        val player = started(BUSY)
        player.pass(2_050)
        player.apply(SessionInput.PlaceRobot(0, Pose(60.0, 40.0, 45.0)))
        player.pass(1_950)
        val states = player.recorded().states(step = 80).toList()
        assertEquals((0L..4_000 step 80).toList(), states.map { it.milliseconds })
        for (state in states) {
            val run = player.again(BUSY, state.milliseconds)
            assertEquals(run.state.robots, state.robots, "at ${state.milliseconds}")
            assertEquals(pointsOf(run.state), pointsOf(state), "at ${state.milliseconds}")
        }
    }

    @Test
    fun `the last state is the end of the run, also between two steps`() = runTest {
        val player = started(BUSY)
        player.pass(1_030)
        assertEquals(listOf(0L, 500L, 1_000L, 1_030L), player.recorded().states(500).map { it.milliseconds }.toList())
    }

    @Test
    fun `a run that goes on does not change what was recorded`() = runTest {
        val player = started(BUSY)
        player.pass(1_000)
        val recorded = player.recorded()
        val states = recorded.states(250).iterator()
        states.next()
        player.pass(3_000)
        player.apply(SessionInput.Stop)
        assertEquals(1_000, recorded.length)
        assertEquals(4, states.asSequence().count())
    }

    @Test
    fun `a run that went on after its task was completed is repeated to its end`() = runTest {
        val world = BuiltInWorlds.plain.copy(goals = listOf(Goal(Reach(Shape.Circle(Point(60.0, 30.0), 5.0)))))
        val player = started("repeat forever\n  forward 5\nend", world)
        player.pass(20_000)
        assertEquals(PlaybackState.Paused, player.playback)
        player.play()
        player.pass(1_000)
        val states = player.recorded().states(step = 80).take(1_000).toList()
        assertEquals(player.time, states.last().milliseconds)
        assertEquals(player.state.robots, states.last().robots)
        assertEquals((0L..<player.time step 80).toList(), states.dropLast(1).map { it.milliseconds })
    }

    @Test
    fun `a run in which nothing happened yet has one state`() = runTest {
        assertEquals(1, started(BUSY).recorded().states(80).count())
    }

    @Test
    fun `a step of no time is a mistake of the caller`() = runTest {
        assertFailsWith<IllegalArgumentException> { started(BUSY).recorded().states(0).first() }
    }

    private fun pointsOf(state: SessionState) = state.ink.strokes.map { it.points.toList() }
}
