package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition.EndWithin
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.ShowOnDisplay
import robotran.world.TouchKind
import kotlin.test.Test
import kotlin.test.assertEquals

class ProgramGoalTest {
    private val running = RunState.Running(1)

    @Test
    fun `whoever has touched something forbidden has failed`() = runTest {
        val run =
            run(
                Goal(NeverTouch()),
                Goal(NeverTouch(setOf(TouchKind.WALLS))),
                Goal(NeverTouch(setOf(TouchKind.ROBOTS, TouchKind.BLOCKS))),
            )
        run.touching(TouchKind.BLOCKS)
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.PENDING, GoalStatus.FAILED), run.goals.map { it.status })
        run.touching()
        run.finish()
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.MET, GoalStatus.FAILED), run.goals.map { it.status })
    }

    @Test
    fun `a program has to come to its end by itself and in time`() = runTest {
        val run = run(Goal(EndWithin(10)))
        run.programIs(running)
        run.programIs(RunState.Ended(stopped = true))
        assertEquals(GoalStatus.PENDING, run.status)
        run.programIs(RunState.Failed(ProgramFailure("No.", 1)))
        assertEquals(GoalStatus.PENDING, run.status)
        run.until(10.0)
        run.programIs(RunState.Ended(stopped = false))
        assertEquals(GoalStatus.FAILED, run.status)
        val inTime = run(Goal(EndWithin(10)))
        inTime.until(9.99)
        inTime.programIs(RunState.Ended(stopped = false))
        assertEquals(GoalStatus.MET, inTime.status)
    }

    @Test
    fun `a text is shown while the program runs`() = runTest {
        val run = run(Goal(ShowOnDisplay(" hello ")))
        run.shows("HELLO")
        assertEquals(GoalStatus.PENDING, run.status)
        run.programIs(running)
        assertEquals(GoalStatus.PENDING, run.status, "left by the firmware")
        run.shows("HALLO")
        assertEquals(GoalStatus.PENDING, run.status)
        run.shows("HELLO")
        assertEquals(GoalStatus.MET, run.status)
        run.shows("")
        assertEquals(GoalStatus.MET, run.status)
    }

    @Test
    fun `tones of the program count, within half a semitone of what is wanted`() = runTest {
        val run =
            run(
                Goal(PlaySound()),
                Goal(PlaySound(times = 3)),
                Goal(PlaySound(lowest = 440, highest = 440)),
                Goal(PlaySound(highest = 400)),
            )
        run.plays(440.0, 1000.0, isFirmware = true)
        assertEquals(List(4) { 0.0 }, run.goals.map { it.progress })
        run.plays(450.0, 500.0)
        assertEquals(listOf(1.0, 0.66, 1.0, 0.0), run.goals.map { it.progress })
        run.plays(400.5)
        assertEquals(List(4) { GoalStatus.MET }, run.goals.map { it.status })
    }
}
