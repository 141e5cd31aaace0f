package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.log.romCalls
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class RunSnippetTest {
    private fun program(text: String): BrickProgram = (
        compileRobolang(
            "now.robo",
            text,
            RobotTarget.Rcx(50.0, 5.0),
            messages = RobolangMessages.of(Language.ENGLISH),
        ) as RobolangResult.Success
    ).program

    private suspend fun session(text: String = "beep") =
        Session(BuiltInWorlds.plain, listOf(program(text)), loadPhysicsEngine(), Language.ENGLISH)

    private fun Session.callsFrom(call: Int) = callLog.entries.drop(call).romCalls().map { it.call }

    @Test
    fun `lines run at once make the calls and the way of the same lines in a program`() = runTest {
        val lines = "pen down\nforward 12\nturn left 75\nforward 8\npen up"
        val sent = session("forward 3")
        val pressed = session(lines)
        for (session in listOf(sent, pressed)) {
            session.apply(SessionInput.PlaceRobot(0, Pose(61.0, 33.0, 140.0)))
            session.advance(1_000)
        }
        val before = listOf(sent, pressed).map { it.callLog.entries.size }
        sent.apply(SessionInput.RunSnippet(program(lines)))
        pressed.apply(SessionInput.Press(BrickButton.RUN))
        pressed.apply(SessionInput.Release(BrickButton.RUN))
        for (session in listOf(sent, pressed)) session.advance(8_000)

        assertEquals(pressed.callsFrom(before[1]), sent.callsFrom(before[0]))
        assertEquals(pressed.traceHash, sent.traceHash)
        assertEquals(pressed.state.ink.lengthCentimetres, sent.state.ink.lengthCentimetres)
        assertEquals(pressed.state.robot, sent.state.robot)
        assertTrue(sent.state.brick.isSnippet)
        assertFalse(pressed.state.brick.isSnippet)
    }

    @Test
    fun `a session with such runs can be repeated`() = runTest {
        val session = session("repeat forever\n  forward 5\nend")
        session.advance(300)
        session.apply(SessionInput.RunSnippet(program("forward 10\nturn right 45")))
        session.advance(700)
        session.apply(SessionInput.RunSnippet(program("backward 4")))
        session.advance(2_000)
        val loads = listOf(RobotProgramSet(listOf(program("repeat forever\n  forward 5\nend"))))
        val again = Session.replay(
            session.world,
            loads,
            loadPhysicsEngine(),
            session.inputs,
            session.milliseconds,
            Language.ENGLISH,
        )
        assertEquals(session.traceHash, again.traceHash)
    }

    @Test
    fun `the robot goes on from where it is, with its pen and its ink`() = runTest {
        val session = session()
        session.apply(SessionInput.RunSnippet(program("pen down\nforward 10")))
        session.advance(3_000)
        val first = session.state
        session.apply(SessionInput.RunSnippet(program("forward 10")))
        session.advance(3_000)
        assertTrue(session.state.robot.penDown)
        assertEquals(2 * first.ink.lengthCentimetres, session.state.ink.lengthCentimetres, 1.0)
        assertNotEquals(first.robot.pose, session.state.robot.pose)
    }

    @Test
    fun `the program that runs is ended first, and Run starts it again afterwards`() = runTest {
        val session = session("repeat forever\n  forward 5\nend")
        val pressRun = {
            session.apply(SessionInput.Press(BrickButton.RUN))
            session.apply(SessionInput.Release(BrickButton.RUN))
        }
        pressRun()
        session.advance(100)
        session.apply(SessionInput.RunSnippet(program("beep")))
        assertTrue(session.state.brick.isSnippet)
        session.advance(500)
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run)
        pressRun()
        session.advance(10)
        assertIs<RunState.Running>(session.state.brick.run)
        assertFalse(session.state.brick.isSnippet)
    }

    @Test
    fun `a brick that is off or shows a failure can be told what to do now`() = runTest {
        val session = session("var zero = 0\nshow 1 / zero")
        session.apply(SessionInput.Press(BrickButton.RUN))
        session.apply(SessionInput.Release(BrickButton.RUN))
        session.advance(200)
        assertIs<RunState.Failed>(session.state.brick.run)
        session.apply(SessionInput.RunSnippet(program("show 7")))
        session.advance(200)
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run)

        session.apply(SessionInput.Press(BrickButton.ON_OFF))
        session.apply(SessionInput.Release(BrickButton.ON_OFF))
        session.advance(1_000)
        assertFalse(session.state.brick.poweredOn)
        val before = session.state.robot.pose
        session.apply(SessionInput.RunSnippet(program("forward 10")))
        session.advance(2_000)
        assertTrue(session.state.brick.poweredOn)
        assertNotEquals(before, session.state.robot.pose)
    }

    @Test
    fun `an endless loop is ended by Stop`() = runTest {
        val session = session()
        session.apply(SessionInput.RunSnippet(program("repeat forever\n  forward 1\nend")))
        session.advance(5_000)
        assertIs<RunState.Running>(session.state.brick.run)
        session.apply(SessionInput.Stop)
        assertEquals(RunState.Ended(stopped = true), session.state.brick.run)
    }

    @Test
    fun `it counts for no goal`() = runTest {
        val world = BuiltInWorlds.plain.copy(goals = listOf(Goal(GoalCondition.InkLength(10.0, null))))
        val session = Session(world, emptyList<BrickProgram>(), loadPhysicsEngine(), Language.ENGLISH)
        val before = session.state.goals
        session.apply(SessionInput.RunSnippet(program("pen down\nforward 30\nturn left 90\nforward 30")))
        session.advance(20_000)
        session.finish()
        assertEquals(before, session.state.goals)
        assertTrue(session.state.goals.all { it.status == GoalStatus.PENDING })
    }

    @Test
    fun `only the robot that was told to does it`() = runTest {
        val place = BuiltInWorlds.plain.robots.single()
        val world = BuiltInWorlds.plain.copy(
            robots = listOf(
                place.copy(start = Pose(30.0, 20.0, 0.0)),
                place.copy(start = Pose(30.0, 60.0, 0.0), name = "other"),
            ),
        )
        val session = Session(world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
        session.apply(SessionInput.RunSnippet(program("forward 10"), robot = 1))
        session.advance(2_000)
        val (first, second) = session.state.robots
        assertEquals(30.0, first.robot.pose.x)
        assertTrue(second.robot.pose.x > 35)
        assertFalse(first.brick.isSnippet)
    }
}
