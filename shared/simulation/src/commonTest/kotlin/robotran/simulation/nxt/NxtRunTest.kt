package robotran.simulation.nxt

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nxt.hardware.SensorPortState
import robotran.nxt.program.NxtCall
import robotran.nxt.state.NxtState
import robotran.simulation.ScriptedProgram
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.explain.Cause
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.report
import robotran.simulation.runUnattended
import robotran.simulation.state.GoalStatus
import robotran.world.Barrier
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.length
import kotlin.math.PI
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** Programs drive robots with an NXT as they would drive real ones. */
class NxtRunTest {
    private val follower = openWorld(ReadyRobots.LINE_FOLLOWER)

    private fun Session.toEnd(milliseconds: Int = 60_000): Session = apply {
        var left = milliseconds
        while (state.brick.run is RunState.Running && left > 0) {
            advance(100)
            left -= 100
        }
        advance(500)
        assertTrue(state.brick.run is RunState.Ended, "${state.brick.run}")
    }

    private fun Session.screenNumbers(): List<List<Int>> = state.brick.screen.lines.map { line ->
        line.trim().split(Regex(" +")).mapNotNull { it.toIntOrNull() }
    }

    @Test
    fun `a free motor turns as far and as long as a real one`() = runTest {
        val session = nxtSession(follower, nxj("Rotations"))
        var shown = emptyList<List<Int>>()
        while (session.state.brick.run is RunState.Running && session.milliseconds < 60_000) {
            session.advance(50)
            if (session.screenNumbers()[4].size == 2) shown = session.screenNumbers()
        }
        val (degrees, milliseconds) = listOf(0, 1).map { column -> shown.take(5).map { it[column] } }
        assertTrue(degrees[0] in 359..361 && milliseconds[0] in 1_150..1_600, "$shown")
        assertTrue(degrees[1] in -1..1 && milliseconds[1] in 1_150..1_600, "$shown")
        assertTrue(degrees[2] in 340..375, "$shown")
        assertTrue(degrees[3] in 650..760, "$shown")
        assertTrue(degrees[4] in 48..52, "$shown")
    }

    @Test
    fun `a regulated motor goes on whatever holds it up to its strength`() = runTest {
        val driving = ScriptedNxt {
            regulate(ScriptedNxt.A, ScriptedNxt.C)
            pause(100_000)
        }
        val session = nxtSession(openWorld(), driving)
        session.advance(3_000)
        val (a, b, c) = session.state.robot.motorDegrees
        assertEquals(3 * 360.0, a, 40.0)
        assertEquals(a, c, 1.0)
        assertEquals(0.0, b)
        assertEquals(a / 360 * 5.6 * PI, session.state.robot.pose.x - 300, 0.3)
        val heavy = Barrier(Shape.Rectangle(Point(330.0, 300.0), 20.0, 60.0))
        val blocked = nxtSession(openWorld().copy(barriers = listOf(heavy)), driving)
        blocked.advance(3_000)
        assertTrue(blocked.state.robot.pose.x < 312)
        assertTrue((blocked.state.brick as NxtState).motors.first().power > 10)
        assertEquals(listOf(Cause.SPIN), blocked.explain().map { it.cause })
    }

    @Test
    fun `a slow motor stalls at a wall and its counter stands`() = runTest {
        val slow = ScriptedNxt {
            motors(20)
            pause(100_000)
        }
        val wall = Barrier(Shape.Rectangle(Point(320.0, 300.0), 20.0, 60.0))
        val session = nxtSession(openWorld().copy(barriers = listOf(wall)), slow)
        session.advance(3_000)
        val before = session.state.robot.motorDegrees
        session.advance(2_000)
        assertEquals(before[0], session.state.robot.motorDegrees[0], 1.0)
        assertTrue(before[0] < 60)
    }

    @Test
    fun `a regulator makes up for weak motors and batteries`() = runTest {
        val driving = ScriptedNxt {
            regulate(ScriptedNxt.A, ScriptedNxt.C)
            pause(100_000)
        }
        val session = nxtSession(openWorld().copy(realism = 1.0, seed = 7), driving)
        session.advance(5_000)
        val (a, _, c) = session.state.robot.motorDegrees
        assertEquals(a, c, 4.0)
        val causes = session.explain().map { it.cause }
        assertTrue(Cause.LEFT_STRENGTH !in causes && Cause.BATTERY !in causes, "$causes")
        assertTrue(Cause.SLIP in causes && Cause.SONAR_NOISE in causes && Cause.LIGHT_NOISE in causes, "$causes")
        assertTrue(session.explain().all { it.sentence.endsWith(".") })
    }

    @Test
    fun `play between motor and wheel is told`() = runTest {
        val session =
            nxtSession(openWorld().copy(realism = 1.0), robolangNxt("repeat 3 times\nforward 5\nbackward 5\nend"))
        session.toEnd()
        assertTrue(Cause.MOTOR_PLAY in session.explain().map { it.cause })
    }

    private fun checkSquare(session: Session, start: Pose) {
        val end = session.state.robot.pose
        assertTrue(length(end.x - start.x, end.y - start.y) < 1.0, "from $start to $end")
        assertEquals(0.0, (end.heading - start.heading + 540).mod(360.0) - 180, 3.0)
        // A motor goes a little too far before it is back, and the pen draws that twice.
        assertEquals(80.0, session.state.ink.lengthCentimetres, 3.0)
        val corners = session.state.ink.strokes.flatMap { it.points }
        assertEquals(20.0, corners.maxOf { it.x } - corners.minOf { it.x }, 0.8)
        assertEquals(20.0, corners.maxOf { it.y } - corners.minOf { it.y }, 0.8)
    }

    @Test
    fun `the square of a pilot is closed`() = runTest(timeout = 3.minutes) {
        checkSquare(nxtSession(nxtPlain, nxj("PilotSquare")).toEnd(), nxtPlain.start)
    }

    @Test
    fun `so is that of Robolang`() = runTest {
        val source = "pen down\nrepeat 4 times\nforward 20\nturn left 90\nend\npen up"
        checkSquare(nxtSession(nxtPlain, robolangNxt(source)).toEnd(), nxtPlain.start)
    }

    @Test
    fun `an NXT follows a line all the way round`() = runTest(timeout = 5.minutes) {
        val loop = assertIs<WorldFileResult.Success>(
            readWorld(BuiltInWorlds.texts.getValue("line-loop.world.json"), Language.ENGLISH),
        ).world
        val robots = loop.robots.map { it.copy(description = ReadyRobots.NXT_PENBOT) }
        val session = nxtSession(loop.copy(robots = robots), nxj("FollowLine"))
        while (session.milliseconds < 90_000 && session.state.goals.single().status == GoalStatus.PENDING) {
            session.advance(500)
        }
        assertEquals(GoalStatus.MET, session.state.goals.single().status, "${session.state.goals.single().progress}")
    }

    @Test
    fun `a robot with a sonar does not run into walls`() = runTest(timeout = 3.minutes) {
        val session = nxtSession(nxtPlain, nxj("Wanderer")).toEnd()
        assertEquals(0, session.state.bumps)
        assertTrue(session.state.trail.isNotEmpty())
        assertTrue(abs(session.state.robot.motorDegrees[0]) > 0)
    }

    @Test
    fun `robots of a world talk over Bluetooth`() = runTest(timeout = 3.minutes) {
        val other = RobotPlacement(Pose(360.0, 300.0, 90.0), name = "red", description = ReadyRobots.NXT_PENBOT)
        val pair: World = openWorld().let { it.copy(robots = it.robots + other) }
        val session = nxtSession(pair, nxj("Caller"), nxj("Answerer"))
        var shown = emptyList<List<Int>>()
        while (session.state.brick.run is RunState.Running && session.milliseconds < 30_000) {
            session.advance(50)
            if (session.screenNumbers()[3].isNotEmpty()) shown = session.screenNumbers()
        }
        assertEquals(60.0, session.state.robots[1].robot.motorDegrees[0], 2.0)
        assertTrue(shown.flatten().containsAll(listOf(1, 4, 9)), "$shown")
    }

    @Test
    fun `robots of a world talk by cable`() = runTest(timeout = 3.minutes) {
        val other = RobotPlacement(Pose(360.0, 300.0, 90.0), name = "red", description = ReadyRobots.NXT_PENBOT)
        val pair: World = openWorld().let { it.copy(robots = it.robots + other) }
        val session = nxtSession(pair, nxj("CableCaller"), nxj("CableAnswerer"))
        session.advance(3_000)
        val (caller, answerer) = session.state.robots.map { robot ->
            robot.brick.screen.lines.map { it.trimEnd() }.filter { it.isNotEmpty() }
        }
        assertEquals(listOf("true", "true", "red true", "1", "4", "9", "-1"), caller)
        assertEquals(listOf("true", "end"), answerer)
    }

    @Test
    fun `an RCX and an NXT drive in one world`() = runTest {
        val rcx = RobotPlacement(Pose(300.0, 200.0, 0.0), name = "red")
        val mixed = openWorld().let { it.copy(robots = it.robots + rcx) }
        val session = nxtSession(mixed, robolangNxt("forward 30"), ScriptedProgram { forward(30.0) })
        session.runUnattended(5_000)
        val (nxt, other) = session.state.robots.map { it.robot.pose.x }
        assertEquals(330.0, nxt, 0.5)
        assertEquals(330.0, other, 0.5)
        assertEquals(emptyList(), session.state.robots[1].robot.motorDegrees)
    }

    @Test
    fun `a goal sees what a program shows`() = runTest {
        val showing = ScriptedNxt {
            pause(500)
            call(NxtCall.drawString("ABCDEFGHIJKLMNOP", 0, 3))
            pause(1_000)
        }
        val wanted = listOf("ABCDEFGHIJKLMNOP", "Run Default").map { Goal(GoalCondition.ShowOnDisplay(it)) }
        val session = nxtSession(nxtPlain.copy(goals = wanted), showing)
        session.advance(400)
        assertEquals(listOf(GoalStatus.PENDING, GoalStatus.PENDING), session.state.goals.map { it.status })
        session.advance(3_000)
        assertEquals(listOf(GoalStatus.MET, GoalStatus.PENDING), session.state.goals.map { it.status })
    }

    @Test
    fun `the report and goals see what a program leaves`() = runTest {
        val showing = ScriptedNxt { call(NxtCall.drawString("Bye", 0, 3)) }
        val wanted = listOf("Bye", "Run Default").map { Goal(GoalCondition.ShowOnDisplay(it)) }
        val session = nxtSession(nxtPlain.copy(goals = wanted), showing)
        session.advance(500)
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run)
        assertTrue(session.state.brick.screen.shows("Run Default"))
        assertEquals(listOf("", "", "", "Bye", "", "", "", ""), session.report().screen)
        assertEquals("Bye", session.report().lcd.trim())
        assertEquals(listOf(GoalStatus.MET, GoalStatus.PENDING), session.state.goals.map { it.status })
    }

    @Test
    fun `sensors have measured before a program starts`() = runTest {
        val session = Session(nxtPlain, emptyList<BrickProgram>(), loadPhysicsEngine(), Language.ENGLISH)
        val raws = session.state.brick.inputs.map { (it as SensorPortState).raw }
        assertEquals(listOf(1_023, 1_023), raws.take(2))
        assertTrue(raws[2] in 100..1_000, "$raws")
        session.close()
    }

    @Test
    fun `Robolang waits for the lamp of a light sensor`() = runTest {
        val session = nxtSession(nxtPlain, robolangNxt("if light < 40\nforward 10\nend")).toEnd()
        assertEquals(nxtPlain.start, session.state.robot.pose)
    }

    @Test
    fun `enter and escape end a program`() = runTest {
        val session = nxtSession(openWorld(), robolangNxt("start forward\nwait 100 seconds"))
        session.advance(1_000)
        session.apply(SessionInput.Press(BrickButton.ENTER))
        session.apply(SessionInput.Press(BrickButton.ESCAPE))
        session.advance(100)
        assertTrue(session.state.brick.run is RunState.Ended)
        session.advance(2_000)
        val stopped = session.state.robot.pose
        session.advance(100)
        assertEquals(stopped, session.state.robot.pose)
    }
}
