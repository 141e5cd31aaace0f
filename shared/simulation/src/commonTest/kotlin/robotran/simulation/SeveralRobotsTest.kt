package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.state.RcxState
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.LightFacing
import robotran.world.Paper
import robotran.world.Penbot
import robotran.world.RobotColour
import robotran.world.RobotPlacement
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class SeveralRobotsTest {
    private fun world(vararg starts: Pose) = BuiltInWorlds.plain.copy(
        walls = emptyList(),
        robots = starts.mapIndexed { number, start ->
            RobotPlacement(start, name = "robot $number", colour = RobotColour.entries[number])
        },
    )

    private val ahead = ScriptedProgram {
        penDown()
        motors(ScriptedProgram.FORWARD, 7)
        pause(4_000)
    }

    private suspend fun session(world: World, vararg programs: ScriptedProgram?): Session {
        val session =
            Session(world, programs.map { RobotProgramSet(listOfNotNull(it)) }, loadPhysicsEngine(), Language.ENGLISH)
        for (robot in programs.indices) {
            session.apply(SessionInput.Press(BrickButton.RUN, robot))
            session.apply(SessionInput.Release(BrickButton.RUN, robot))
        }
        return session
    }

    @Test
    fun `each robot runs its own program and draws with its own pen`() = runTest {
        val session =
            session(world(Pose(20.0, 20.0, 0.0), Pose(20.0, 60.0, 0.0)), ahead, ScriptedProgram { forward(5.0) })
        session.advance(2_000)
        val (first, second) = session.state.robots
        assertTrue(first.robot.pose.x > 60)
        assertEquals(25.0, second.robot.pose.x, 0.2)
        assertIs<RunState.Running>(first.brick.run)
        assertIs<RunState.Ended>(second.brick.run)
        assertEquals(listOf(0), session.state.ink.strokes.map { it.robot })
    }

    @Test
    fun `two robots that meet head on stop each other`() = runTest {
        val session = session(world(Pose(20.0, 40.0, 0.0), Pose(80.0, 40.0, 180.0)), ahead, ahead)
        session.advance(3_500)
        val (first, second) = session.state.robots
        assertEquals(50.0 - Penbot.BUMPER_FRONT, first.robot.pose.x, 0.3)
        assertEquals(50.0 + Penbot.BUMPER_FRONT, second.robot.pose.x, 0.3)
        assertEquals(setOf(TouchKind.ROBOTS), first.robot.touching)
        assertTrue(first.robot.leftBumperPressed && second.robot.rightBumperPressed)
    }

    @Test
    fun `a robot pushes one that floats`() = runTest {
        val session = session(world(Pose(20.0, 40.0, 0.0), Pose(50.0, 40.0, 0.0)), ahead, null)
        session.advance(4_000)
        assertTrue(session.state.robots[1].robot.pose.x > 60, session.state.robots[1].robot.pose.toString())
    }

    @Test
    fun `a robot is seen by another's light sensor, and more so with a beacon`() = runTest {
        val apart = world(Pose(20.0, 40.0, 0.0), Pose(90.0, 10.0, 180.0))
        val near = world(Pose(20.0, 40.0, 0.0), Pose(52.0, 40.0, 180.0))
        val lit = near.copy(robots = listOf(near.robots[0], near.robots[1].copy(beacon = 1.0)))
        val looking = ScriptedProgram {
            activate(port = 1)
            pause(9_000)
        }
        val raws = listOf(apart, near, lit).map { world ->
            val looks = world.copy(robots = world.robots.map { it.copy(lightFacing = LightFacing.FORWARD) })
            (session(looks, looking, null).apply { advance(50) }.state.brick as RcxState).sensors[1].raw
        }
        assertEquals(raws.sortedDescending().distinct(), raws)
    }

    @Test
    fun `one brick hears what another sends, if it is not too far for a short range`() = runTest {
        suspend fun heard(distance: Double): Boolean {
            val sender = MessageProgram(sends = listOf(0x10))
            val receiver = MessageProgram(sends = emptyList())
            val wide = world(Pose(10.0, 40.0, 0.0), Pose(10.0 + distance, 40.0, 0.0)).copy(paper = Paper(300.0, 80.0))
            val session =
                Session(
                    wide,
                    listOf(RobotProgramSet(listOf(sender)), RobotProgramSet(listOf(receiver))),
                    loadPhysicsEngine(),
                    Language.ENGLISH,
                )
            for (robot in 0..1) {
                session.apply(SessionInput.Press(BrickButton.RUN, robot))
                session.apply(SessionInput.Release(BrickButton.RUN, robot))
            }
            session.advance(1_000)
            return receiver.hasHeard
        }
        assertTrue(heard(60.0))
        assertEquals(false, heard(200.0))
    }

    @Test
    fun `stop ends all programs`() = runTest {
        val session = session(world(Pose(20.0, 20.0, 0.0), Pose(20.0, 60.0, 0.0)), ahead, ahead)
        session.advance(500)
        session.apply(SessionInput.Stop)
        session.advance(1)
        assertTrue(session.state.robots.all { it.brick.run is RunState.Ended })
    }

    @Test
    fun `a robot that is picked up drives on where it is put down, and draws nothing on the way`() = runTest {
        val session = session(world(Pose(20.0, 20.0, 0.0)), ahead)
        session.advance(1_000)
        session.apply(SessionInput.PlaceRobot(0, Pose(20.0, 60.0, 90.0)))
        session.advance(500)
        val pose = session.state.robot.pose
        assertEquals(20.0, pose.x, 0.5)
        assertTrue(pose.y in 65.0..75.0, pose.toString())
        assertEquals(2, session.state.ink.strokes.size)
    }

    @Test
    fun `inputs count as a file can keep them`() = runTest {
        val session = session(world(Pose(20.0, 20.0, 0.0)), null)
        session.apply(SessionInput.PlaceRobot(0, Pose(33.33333, 44.44444, Double.NaN)))
        assertEquals(SessionInput.PlaceRobot(0, Pose(33.333, 44.444, 0.0)), session.inputs.last().input)
    }

    @Test
    fun `inputs for what is not there do nothing`() = runTest {
        val session = session(world(Pose(20.0, 20.0, 0.0)), null)
        session.apply(SessionInput.Press(BrickButton.RUN, robot = 5))
        session.apply(SessionInput.PlaceRobot(-1, Pose(0.0, 0.0, 0.0)))
        session.apply(SessionInput.MoveLamp(3, Point(1.0, 1.0)))
        session.apply(SessionInput.TouchSensor(robot = 0, port = 7, pressed = true))
        session.advance(10)
        assertEquals(10, session.state.milliseconds)
    }

    @Test
    fun `another robot can be looked into`() = runTest {
        val session =
            session(world(Pose(20.0, 20.0, 0.0), Pose(20.0, 60.0, 0.0)), ahead, ScriptedProgram { forward(5.0) })
        session.advance(2_000)
        val first = session.callLog.total
        session.watched = 1
        assertNotEquals(first, session.callLog.total)
    }
}
