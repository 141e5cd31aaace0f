package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.AmbientConditions
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.length
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertSame
import kotlin.test.assertTrue

class TrailTest {
    @Test
    fun `the trail tells where the robot has driven, pen up or down`() = runTest {
        val program = ScriptedProgram {
            motors(ScriptedProgram.FORWARD, 3)
            pause(1_000)
            motors(ScriptedProgram.BRAKE, 7)
        }
        val state = runToEnd(program).state
        assertEquals(0.0, state.ink.lengthCentimetres)
        val piece = state.trail.single()
        assertEquals(0, piece.robot)
        assertEquals(BuiltInWorlds.plain.start.let { Point(it.x, it.y) }, piece.points.first())
        val pose = state.robot.pose
        assertEquals(0.0, length(piece.points.last().x - pose.x, piece.points.last().y - pose.y), 0.1)
        assertTrue(piece.points.size < 5, "a straight way has few corners, not ${piece.points.size}")
    }

    @Test
    fun `where a robot is carried is no part of its trail`() = runTest {
        val session = Session(BuiltInWorlds.plain, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
        session.advance(100)
        session.apply(SessionInput.PlaceRobot(0, Pose(20.0, 20.0, 0.0)))
        session.advance(100)
        assertEquals(2, session.state.trail.size)
        assertEquals(listOf(Point(20.0, 20.0)), session.state.trail.last().points)
    }

    @Test
    fun `the trail of a robot that stands still is the same object`() = runTest {
        val session = Session(BuiltInWorlds.plain, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
        session.advance(100)
        val before = session.state.trail
        session.advance(100)
        assertSame(before, session.state.trail)
    }

    @Test
    fun `light and warmth are told as they are now`() = runTest {
        val world = BuiltInWorlds.plain.copy(ambientLight = 1.5, temperature = 12.0)
        val session = Session(world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), Language.ENGLISH)
        assertEquals(AmbientConditions(1.5, 12.0), session.state.surroundings)
        session.apply(SessionInput.ChangeAmbientLight(0.25))
        session.apply(SessionInput.ChangeTemperature(30.0))
        assertEquals(AmbientConditions(0.25, 30.0), session.state.surroundings)
    }
}
