package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class WallTest {
    /** The right wall of the plain sheet begins at the paper's edge. */
    private val wall = BuiltInWorlds.plain.paper.width

    private fun driveFor(milliseconds: Long, power: Int) = ScriptedProgram {
        motors(ScriptedProgram.FORWARD, power)
        pause(milliseconds)
        motors(ScriptedProgram.BRAKE, 7)
    }

    @Test
    fun `a wall stops the robot`() = runTest {
        val pose = runToEnd(driveFor(6_000, power = 3)).state.robot.pose
        assertEquals(wall - Penbot.BUMPER_FRONT, pose.x, 0.1)
        assertEquals(0.0, pose.heading, 0.5)
    }

    @Test
    fun `the robot never gets a millimetre into a wall`() = runTest {
        val session = startRun(driveFor(6_000, power = 7))
        repeat(7_000) {
            session.advance(1)
            val front = session.state.robot.pose.x + Penbot.BUMPER_FRONT
            assertTrue(front < wall + 0.1, "the front is at $front after ${session.state.milliseconds} ms")
        }
    }

    /** Distance that the left tyre rolls in a second while the robot pushes against the wall, in centimetres. */
    private suspend fun turnedAtWall(power: Int): Double {
        val session = startRun(driveFor(20_000, power))
        session.advance(14_000)
        val before = session.state.robot
        session.advance(1_000)
        val after = session.state.robot
        assertEquals(before.pose.x, after.pose.x, 0.02)
        return (after.leftWheelTurn - before.leftWheelTurn) * Penbot.WHEEL_CIRCUMFERENCE
    }

    @Test
    fun `at full power the wheels slip at a wall, slower than they would run free`() = runTest {
        val turned = turnedAtWall(power = 7)
        assertTrue(turned > 0.5 * Penbot.TOP_SPEED && turned < 0.8 * Penbot.TOP_SPEED, "they turned $turned cm")
    }

    @Test
    fun `at power four the tyres are just the weaker`() = runTest {
        val turned = turnedAtWall(power = 4)
        assertTrue(turned > 1 && turned < 0.5 * Penbot.TOP_SPEED, "they turned $turned cm")
    }

    @Test
    fun `at little power the motors stall at a wall`() = runTest {
        assertEquals(0.0, turnedAtWall(power = 0), 0.05)
        assertEquals(0.0, turnedAtWall(power = 2), 0.05)
    }

    @Test
    fun `a bump is counted once however long the robot pushes`() = runTest {
        val session = runToEnd(driveFor(10_000, power = 3))
        assertEquals(1, session.state.bumps)
        assertTrue(session.state.robot.leftBumperPressed)
        assertTrue(session.state.robot.rightBumperPressed)
    }

    @Test
    fun `bumpers come out when the robot backs off and count again when it comes back`() = runTest {
        val program = ScriptedProgram {
            forward(60.0)
            backward(5.0)
            forward(10.0)
            backward(5.0)
        }
        val state = runToEnd(program).state
        assertEquals(2, state.bumps)
        assertFalse(state.robot.leftBumperPressed)
        assertFalse(state.robot.rightBumperPressed)
    }

    @Test
    fun `a robot that meets a wall at an angle slides along it and turns`() = runTest {
        val world = BuiltInWorlds.plain.withStart(Pose(60.0, 20.0, 40.0))
        val pose = runToEnd(driveFor(8_000, power = 3), world).state.robot.pose
        assertTrue(pose.x < wall - Penbot.CHASSIS_WIDTH / 2, "it stands at ${pose.x}")
        assertTrue(pose.heading != 40.0, "it looks to ${pose.heading}")
    }
}
