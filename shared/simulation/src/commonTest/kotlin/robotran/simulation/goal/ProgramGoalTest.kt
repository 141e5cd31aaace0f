package robotran.simulation.goal

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.runToEnd
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition.EndWithin
import robotran.world.GoalCondition.InOrder
import robotran.world.GoalCondition.NeverTouch
import robotran.world.GoalCondition.PlaySound
import robotran.world.GoalCondition.ShowOnDisplay
import robotran.world.TouchKind
import robotran.world.file.BuiltInWorlds
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
    fun `a text that has to stay must be there at last`() = runTest {
        val run = run(Goal(ShowOnDisplay("4", stays = true)))
        run.programIs(running)
        run.shows("4")
        assertEquals(GoalStatus.PENDING to true, run.status to run.goal.holds)
        run.shows("5")
        assertEquals(GoalStatus.PENDING to false, run.status to run.goal.holds)
        run.finish()
        assertEquals(GoalStatus.FAILED, run.status)
        val again = run(Goal(ShowOnDisplay("4", stays = true)))
        again.programIs(running)
        listOf("4", "5", "4").forEach { again.shows(it) }
        again.finish()
        assertEquals(GoalStatus.MET, again.status)
    }

    @Test
    fun `a number of tones is met by the end of the run, and by one tone too many never`() = runTest {
        val run = run(Goal(PlaySound(times = 2)))
        run.plays(440.0, 440.0)
        assertEquals(GoalStatus.PENDING to true, run.status to run.goal.holds)
        run.finish()
        assertEquals(GoalStatus.MET, run.status)
        val tooMany = run(Goal(PlaySound(times = 2)), Goal(PlaySound(times = 1, highest = 400)))
        tooMany.plays(440.0, 300.0, 440.0)
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.PENDING), tooMany.goals.map { it.status })
        tooMany.finish()
        assertEquals(listOf(GoalStatus.FAILED, GoalStatus.MET), tooMany.goals.map { it.status })
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
        run.finish()
        assertEquals(List(4) { GoalStatus.MET }, run.goals.map { it.status })
    }

    @Test
    fun `a program that shows and beeps at once meets goals that want both in this order and no others`() = runTest {
        val shows = Goal(ShowOnDisplay("7"))
        val beeps = Goal(PlaySound(1))
        for (world in listOf(BuiltInWorlds.plain, BuiltInWorlds.plainFor(BrickKind.NXT))) {
            val brick = world.robots.first().description.brick

            suspend fun metBy(source: String, vararg order: Goal): List<GoalStatus> {
                val drive = world.robots.first().description.drive
                val target = if (brick == BrickKind.NXT) {
                    RobotTarget.Nxt(drive.wheelDiameter, drive.track)
                } else {
                    RobotTarget.Rcx(50.0, 5.0)
                }
                val program = (
                    compileRobolang(
                        "goals",
                        source,
                        target,
                        messages = RobolangMessages.of(Language.ENGLISH),
                    ) as RobolangResult.Success
                ).program
                val goals = listOf(Goal(InOrder(order.toList())))
                return runToEnd(program, world.copy(goals = goals)).also { it.finish() }.state.goals.map { it.status }
            }
            val met = listOf(GoalStatus.MET)
            val failed = listOf(GoalStatus.FAILED)
            assertEquals(met, metBy("show 7\nbeep\nwait 1 second", shows, beeps), "$brick")
            assertEquals(met, metBy("beep\nshow 7\nwait 1 second", beeps, shows), "$brick")
            assertEquals(failed, metBy("beep\nshow 7\nwait 1 second", shows, beeps), "$brick")
            assertEquals(failed, metBy("play 440 for 0.1 seconds\nshow 7\nwait 1 second", shows, beeps), "$brick")
            // Nobody could read it.
            assertEquals(failed, metBy("show 7\nbeep\nshow 8\nwait 1 second", shows, beeps), "$brick")
        }
    }
}
