package robotran.runcontrol

import kotlinx.coroutines.test.runTest
import robotran.brick.log.CallGroup
import robotran.brick.log.CallLogFilter
import robotran.simulation.SessionInput
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.Reach
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class RunRecordTest {
    @Test
    fun `the timeline has the start, beeps, bumps and the end of a run`() = runTest {
        val player = started("beep\nforward 5\nstart forward\nwait 9 seconds\nstop")
        player.pass(14_000)
        val kinds = player.marks.map { it.kind }
        assertEquals(MarkKind.START, player.marks.first { it.kind != MarkKind.BEEP }.kind)
        assertTrue(MarkKind.BEEP in kinds && MarkKind.BUMP in kinds && MarkKind.END in kinds, "$kinds")
        assertEquals(player.marks.map { it.milliseconds }.sorted(), player.marks.map { it.milliseconds })
    }

    @Test
    fun `a failure is on the timeline with its reason`() = runTest {
        val player = started("var zero = 0\nshow 5 / zero")
        player.pass(500)
        val failure = player.marks.single { it.kind == MarkKind.FAILURE }
        assertTrue(failure.text.isNotEmpty())
    }

    @Test
    fun `goals are decided when the run is over, and again the same when it is gone through once more`() = runTest {
        val world = BuiltInWorlds.plain.copy(
            goals = listOf(Goal(NeverTouch()), Goal(InkLength(atLeast = 5.0, atMost = null))),
        )
        val source = "pen down\nforward 10\npen up"
        val player = started(source, world)
        player.pass(6_000)
        assertTrue(player.state.goals.all { it.status == GoalStatus.MET }, "${player.state.goals}")
        assertEquals(2, player.marks.count { it.kind == MarkKind.GOAL })
        val decided = player.state.goals
        player.seek(300)
        player.finishSeeking()
        assertTrue(player.state.goals.all { it.status == GoalStatus.PENDING })
        player.seek(6_000)
        player.finishSeeking()
        assertEquals(decided, player.state.goals)
    }

    @Test
    fun `time stops when the task is completed, goes on if wanted, and does not stop again`() = runTest {
        val flag = Shape.Circle(Point(60.0, 30.0), 5.0)
        val world = BuiltInWorlds.plain.copy(goals = listOf(Goal(Reach(flag))))
        val player = started("repeat forever\n  forward 5\nend", world)
        player.pass(20_000)
        assertEquals(PlaybackState.Paused, player.playback)
        assertTrue(player.outcome.isSolved)
        assertEquals(player.outcome.finished, player.time)
        assertTrue(player.state.robot.pose.x in 55.0..56.0, "${player.state.robot.pose}")
        player.play()
        player.pass(2_000)
        assertEquals(player.outcome.finished?.plus(2_000), player.time)
    }

    @Test
    fun `time stops when the task's time is up, goes on if wanted, and does not stop again`() = runTest {
        val flag = Shape.Circle(Point(90.0, 30.0), 5.0)
        val world = BuiltInWorlds.plain.copy(goals = listOf(Goal(Reach(flag))), timeLimit = 2)
        val player = started("repeat forever\n  wait 1 second\nend", world)
        player.pass(5_000)
        assertEquals(PlaybackState.Paused, player.playback)
        assertEquals(2_000, player.time)
        assertFalse(player.outcome.isSolved)
        player.play()
        player.pass(3_000)
        assertEquals(5_000, player.time)
        val free = started("repeat forever\n  wait 1 second\nend", BuiltInWorlds.plain.copy(timeLimit = 2))
        free.pass(5_000)
        assertEquals(5_000, free.time)
    }

    @Test
    fun `a goal that is a minimum or must hold until the end lets the run go on`() = runTest {
        for (goal in listOf(InkLength(atLeast = 5.0, atMost = null), NeverTouch())) {
            val player = started("pen down\nforward 20", BuiltInWorlds.plain.copy(goals = listOf(Goal(goal))))
            player.pass(10_000)
            assertEquals(10_000, player.time)
            assertTrue(player.outcome.isSolved)
        }
    }

    @Test
    fun `what was missing is known while an earlier time is shown`() = runTest {
        val flag = Shape.Circle(Point(90.0, 30.0), 5.0)
        val player = started("forward 10", BuiltInWorlds.plain.copy(goals = listOf(Goal(Reach(flag)))))
        player.pass(6_000)
        val shortfall = assertNotNull(player.outcome.goals.single().shortfall)
        player.seek(500)
        player.finishSeeking()
        assertNull(player.state.goals.single().shortfall)
        assertEquals(shortfall, player.outcome.goals.single().shortfall)
    }

    @Test
    fun `a run of an hour is kept in bounded memory`() = runTest {
        val player = started("repeat 100000 times\n  beep\n  wait 1 second\nend")
        player.speed = RunSpeed.FASTEST
        player.pass(1_000_000)
        assertTrue(player.marks.size <= MarkTrack.CAPACITY)
        val line = player.chart(ChartLane.SENSOR_1)
        assertTrue(
            line.size <= ChartTrack.CAPACITY && line.size > ChartTrack.CAPACITY / 4,
            "${line.size} of ${line.step} ms",
        )
        player.seek(500_000)
        val state = player.state.milliseconds
        assertTrue(state in 498_000..500_000, "$state")
    }

    @Test
    fun `the chart keeps the shortest press, however coarse it becomes`() = runTest {
        val player = RunPlayer(setupOf("beep"))
        player.pass(1_000)
        val quiet = player.chart(ChartLane.MOTOR_A).let { line ->
            (0..<line.size).all { line.range(it) == 0..0 }
        }
        assertTrue(quiet)
        val driven = started("forward 1")
        driven.pass(100_000)
        val line = driven.chart(ChartLane.MOTOR_A)
        assertTrue(line.step > 10)
        assertTrue((0..<line.size).any { checkNotNull(line.range(it)).last > 0 })
        assertEquals(line.size - 1, line.pieceAt(Long.MAX_VALUE))
    }

    @Test
    fun `it is known when ROM calls were made, however long the run`() = runTest {
        val player = started("beep\nwait 3 seconds\nbeep\nwait 100 seconds\nbeep")
        player.pass(2_000)
        val atFirst = player.callLine.between(-1, 2_000)
        assertTrue(atFirst > 0)
        assertEquals(0, player.callLine.between(2_000, 2_000))
        player.pass(108_000)
        val line = player.callLine
        assertTrue(line.size <= RomCallTrack.CAPACITY && line.step > 10)
        assertEquals(player.state.robots[0].romCalls, line.between(-1, 110_000))
        assertTrue(line.between(1_000, 2_500) < line.between(2_500, 4_000))
        player.seek(2_000)
        player.finishSeeking()
        assertEquals(player.state.robots[0].romCalls, player.callLine.between(-1, 2_000))
        assertEquals(line.between(-1, 110_000), player.callLine.between(-1, 110_000))
        player.apply(SessionInput.Stop)
        player.play()
        player.pass(100)
        assertEquals(player.state.robots[0].romCalls, player.callLine.between(-1, 110_000))
    }

    @Test
    fun `ROM calls are those up to now, also in the past`() = runTest {
        val player = started(BUSY)
        player.pass(2_000)
        val calls = player.romCalls.entries.toList()
        player.pass(4_000)
        assertTrue(player.romCalls.entries.size > calls.size)
        player.seek(2_000)
        player.finishSeeking()
        assertEquals(calls, player.romCalls.entries.toList())
    }

    @Test
    fun `a filter finds the same calls whether the run goes on, back or on again`() = runTest {
        val player = started(BUSY)
        val filter = CallLogFilter(groups = setOf(CallGroup.MOTORS))
        val calls = FilteredRomCalls(filter)

        fun expected() = player.romCalls.entries.filter(filter::accepts)
        for (time in listOf(1_000L, 3_000L, 6_000L, 2_000L, 2_500L, 6_000L)) {
            if (time > player.length) player.pass((time - player.length).toInt()) else player.seek(time)
            player.finishSeeking()
            player.play()
            assertEquals(expected(), calls.find(player.romCalls), "at $time")
            assertTrue(calls.isComplete)
        }
        assertTrue(expected().isNotEmpty())
    }

    @Test
    fun `a new future has marks, chart and calls of its own`() = runTest {
        val player = started(BUSY)
        player.pass(8_000)
        player.seek(1_000)
        player.finishSeeking()
        player.apply(SessionInput.Stop)
        player.play()
        player.pass(2_000)
        assertEquals(3_000, player.length)
        assertTrue(player.marks.all { it.milliseconds <= 3_000 })
        assertEquals(1, player.marks.count { it.kind == MarkKind.END })
        val line = player.chart(ChartLane.MOTOR_A)
        assertEquals(301, line.size)
        assertEquals(0, line.range(300)?.last)
    }

    @Test
    fun `nothing is awake when a robot stands still, and everything while one runs`() = runTest {
        val player = RunPlayer(setupOf("wait 3 seconds"))
        val pauseClock = IdleDetector()

        fun pass(milliseconds: Int) = repeat(milliseconds / 20) {
            player.pass(20)
            pauseClock.passed(player.state)
        }
        pass(1_000)
        assertFalse(pauseClock.isAwake(player.state))
        pauseClock.disturb()
        assertTrue(pauseClock.isAwake(player.state))
        player.pressRun()
        pass(2_000)
        assertTrue(pauseClock.isAwake(player.state))
        pass(1_300)
        assertTrue(pauseClock.isAwake(player.state), "time goes on until the goals are decided")
        pass(2_000)
        assertFalse(pauseClock.isAwake(player.state))
    }
}
