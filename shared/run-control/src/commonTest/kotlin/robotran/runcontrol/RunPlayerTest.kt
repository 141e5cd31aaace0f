package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.brick.program.StepKind
import robotran.brick.state.RunState
import robotran.simulation.Breakpoint
import robotran.simulation.SessionInput
import robotran.simulation.StopReason
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class RunPlayerTest {
    @Test
    fun `going back gives the same run at the same time`() = runTest {
        val player = started(BUSY)
        player.pass(3_000)
        val hash = player.session.traceHash
        val state = player.state
        player.pass(4_000)
        player.seek(3_000)
        player.finishSeeking()
        assertEquals(3_000, player.time)
        assertEquals(hash, player.session.traceHash)
        assertEquals(state.robots, player.state.robots)
        assertEquals(PlaybackState.Paused, player.playback)
    }

    @Test
    fun `there and back again is the run that went straight on`() = runTest {
        val player = started(BUSY)
        player.pass(5_000)
        for (time in listOf(1_234L, 4_000L, 17L, 5_000L, 2_500L)) {
            player.seek(time)
            player.finishSeeking()
            assertEquals(player.again(BUSY, time).traceHash, player.session.traceHash, "at $time")
        }
        player.play()
        player.pass(4_500)
        assertEquals(player.again(BUSY, 7_000).traceHash, player.session.traceHash)
        assertEquals(7_000, player.length)
        assertFalse(player.isInPast)
    }

    @Test
    fun `what is done in the past begins a new future and leaves the past as it was`() = runTest {
        val player = started(BUSY)
        player.pass(6_000)
        val before = player.marks.filter { it.milliseconds <= 2_000 }
        player.seek(2_000)
        player.finishSeeking()
        val hash = player.session.traceHash
        player.apply(SessionInput.PlaceRobot(0, Pose(60.0, 40.0, 45.0)))
        assertEquals(1, player.branchCount)
        assertEquals(2_000, player.length)
        assertEquals(before, player.marks)
        player.play()
        player.pass(3_000)
        assertEquals(player.again(BUSY, 5_000).traceHash, player.session.traceHash)
        player.seek(1_999)
        player.finishSeeking()
        assertEquals(player.again(BUSY, 1_999).traceHash, player.session.traceHash)
        assertNotEquals(hash, player.session.traceHash)
        assertEquals(5_000, player.length)
    }

    @Test
    fun `what is done on the way to another time is done there`() = runTest {
        val player = started(BUSY)
        player.pass(6_000)
        player.seek(2_000)
        player.apply(SessionInput.Stop)
        assertIs<PlaybackState.Seeking>(player.playback)
        player.finishSeeking()
        assertEquals(2_000, player.inputs.last().milliseconds)
        assertEquals(SessionInput.Stop, player.inputs.last().input)
    }

    @Test
    fun `a place of the past is shown before it has been computed again`() = runTest {
        val player = started(BUSY)
        player.pass(6_000)
        player.seek(1_005)
        assertIs<PlaybackState.Seeking>(player.playback)
        assertEquals(1_000, player.state.milliseconds)
        assertEquals(1_005, player.time)
        assertEquals(player.again(BUSY, 1_000).state.robots, player.state.robots)
        assertTrue(player.progress < 1)
        player.frames(60)
        assertEquals(1_005, player.state.milliseconds)
    }

    @Test
    fun `playing in the past goes on into what was not known yet`() = runTest {
        val player = started(BUSY)
        player.pass(1_000)
        player.seek(500)
        player.play()
        player.finishSeeking()
        player.pass(2_000)
        assertEquals(2_500, player.length)
        assertEquals(player.again(BUSY, 2_500).traceHash, player.session.traceHash)
    }

    @Test
    fun `steps go into a procedure, over it and out of it while time passes bit by bit`() = runTest {
        val player = started(BUSY)
        player.pause()

        fun step(kind: StepKind): Int {
            player.step(kind)
            player.untilStill()
            assertEquals(StopReason.StepDone, player.stop)
            return player.line
        }
        assertEquals(listOf(7, 8, 9), List(3) { step(StepKind.INTO) })
        assertEquals(10, step(StepKind.OVER))
        assertEquals(listOf(11, 7, 8, 9, 2), List(5) { step(StepKind.INTO) })
        assertEquals(10, step(StepKind.OUT))
    }

    @Test
    fun `stepping over a drive shows it at the speed that was chosen`() = runTest {
        val player = started("forward 20\nbeep")
        player.step(StepKind.OVER)
        player.frames(20)
        assertIs<PlaybackState.Stepping>(player.playback)
        assertTrue(player.time in 290..320, "it is ${player.time}")
        player.untilStill()
        assertEquals(2, player.line)
    }

    @Test
    fun `a run to a line stops there once, and breakpoints stop every time`() = runTest {
        val player = started(BUSY)
        player.play(until = Breakpoint(10))
        player.untilStill()
        assertEquals(StopReason.Breakpoint(10), player.stop)
        player.breakpoints = setOf(Breakpoint(8))
        player.play()
        player.untilStill()
        assertEquals(8, player.line)
        assertEquals(1, player.session.variables.last().variables.count { it.name == "round" && it.value == "1" })
        player.play()
        player.untilStill()
        assertEquals(StopReason.Breakpoint(8), player.stop)
    }

    @Test
    fun `a breakpoint stops a program that is started later`() = runTest {
        val player = RunPlayer(setupOf("beep\nbeep"))
        player.breakpoints = setOf(Breakpoint(2))
        player.pass(500)
        player.pressRun()
        player.untilStill()
        assertEquals(2, player.line)
    }

    @Test
    fun `a breakpoint stops in the past too, and what is seen there is the run`() = runTest {
        val player = started(BUSY)
        player.pass(6_000)
        player.breakpoints = setOf(Breakpoint(10))
        player.seek(0)
        player.play()
        player.untilStill()
        assertEquals(10, player.line)
        assertTrue(player.isInPast)
        val here = player.time
        player.seek(here)
        player.finishSeeking()
        assertEquals(player.again(BUSY, here).traceHash, player.session.traceHash)
    }

    @Test
    fun `a recording is played from its beginning`() = runTest {
        val first = started(BUSY)
        first.pass(1_500)
        first.apply(SessionInput.PlaceRobot(0, Pose(50.0, 30.0, 90.0)))
        first.pass(2_000)
        val second = RunPlayer(setupOf(BUSY), first.inputs)
        assertEquals(1_500, second.length)
        assertTrue(second.isInPast)
        second.pass(3_500)
        assertEquals(first.session.traceHash, second.session.traceHash)
        assertEquals(first.inputs, second.inputs)
    }

    @Test
    fun `a breakpoint of another robot stops the run before its line and changes nothing`() = runTest {
        val two = BuiltInWorlds.plain.copy(
            robots = listOf(
                BuiltInWorlds.plain.robots.first(),
                BuiltInWorlds.plain.robots.first().copy(start = Pose(20.0, 60.0, 0.0), name = "other"),
            ),
        )
        val player = started(BUSY, two)
        player.watched = 1
        player.otherBreakpoints = mapOf(0 to setOf(Breakpoint(2)))
        player.pass(3_000)
        val stop = player.stop as? StopReason.Breakpoint
        assertEquals(2 to 0, stop?.line to stop?.robot)
        assertEquals(PlaybackState.Paused, player.playback)
        val stopped = player.time
        player.watched = 0
        assertEquals(stopped to true, player.time to player.session.isBeforeStatement)
        player.otherBreakpoints = emptyMap()
        player.play()
        player.pass(1_000)
        assertEquals(player.again(BUSY, player.time, two).traceHash, player.session.traceHash)
    }

    @Test
    fun `several robots run, and the one that is watched can be stepped through`() = runTest {
        val two = BuiltInWorlds.plain.copy(
            robots = listOf(
                BuiltInWorlds.plain.robots.first(),
                BuiltInWorlds.plain.robots.first().copy(start = Pose(20.0, 60.0, 0.0), name = "other"),
            ),
        )
        val player = started(BUSY, two)
        player.watched = 1
        player.step(StepKind.INTO)
        player.untilStill()
        assertEquals(StopReason.StepDone, player.stop)
        player.play()
        player.pass(3_000)
        player.seek(1_000)
        player.finishSeeking()
        assertEquals(1, player.session.watched)
        assertEquals(player.again(BUSY, 1_000, two).traceHash, player.session.traceHash)
        assertTrue(player.romCalls.count > 0)
    }

    @Test
    fun `with no program a step stands still`() = runTest {
        val player = RunPlayer(setupOf("beep"))
        player.step(StepKind.INTO)
        player.pass(10)
        assertEquals(PlaybackState.Paused, player.playback)
        assertEquals(StopReason.Ended, player.stop)
    }

    @Test
    fun `a goal in which the robot already stands does not end the run before the program has`() = runTest {
        val start = BuiltInWorlds.plain.robots.first().start
        val goal = Goal(GoalCondition.Reach(Shape.Circle(Point(start.x, start.y), 10.0)))
        val world = BuiltInWorlds.plain.copy(goals = listOf(goal))
        val player = started("forward 20", world)
        player.untilStill()
        assertTrue(player.state.brick.run is RunState.Ended, "The run stops after ${player.time} ms.")
        assertEquals(GoalStatus.MET, player.outcome.goals.single().status)
    }
}
