package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.simulation.robot.RcxMotor
import robotran.world.Penbot
import robotran.world.file.BuiltInWorlds
import robotran.world.robot.RobotParameters
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DrivingTest {
    private val start = BuiltInWorlds.plain.start

    @Test
    fun `forward 20 goes 20 centimetres straight on`() = runTest {
        val pose = runToEnd(ScriptedProgram { forward(20.0) }).state.robot.pose
        assertEquals(start.x + 20, pose.x, 0.2)
        assertEquals(start.y, pose.y, 0.01)
        assertEquals(start.heading, pose.heading, 0.1)
    }

    @Test
    fun `backward 20 goes 20 centimetres straight back`() = runTest {
        val pose = runToEnd(ScriptedProgram { backward(20.0) }).state.robot.pose
        assertEquals(start.x - 20, pose.x, 0.2)
        assertEquals(start.y, pose.y, 0.01)
    }

    @Test
    fun `turn left 90 turns a quarter counter-clockwise on the spot`() = runTest {
        val pose = runToEnd(ScriptedProgram { turnLeft(90.0) }).state.robot.pose
        assertEquals(90.0, pose.heading, 1.0)
        assertEquals(start.x, pose.x, 0.05)
        assertEquals(start.y, pose.y, 0.05)
    }

    @Test
    fun `turn right 90 turns a quarter clockwise`() = runTest {
        assertEquals(-90.0, runToEnd(ScriptedProgram { turnRight(90.0) }).state.robot.pose.heading, 1.0)
    }

    @Test
    fun `a square ends where it began`() = runTest {
        val pose = runToEnd(ScriptedProgram.square).state.robot.pose
        assertEquals(start.x, pose.x, 0.5)
        assertEquals(start.y, pose.y, 0.5)
        assertEquals(start.heading, pose.heading, 2.0)
    }

    @Test
    fun `the wheels turn as far as the tyres roll`() = runTest {
        val robot = runToEnd(ScriptedProgram { forward(20.0) }).state.robot
        assertEquals(20.0 / Penbot.WHEEL_CIRCUMFERENCE, robot.leftWheelTurn, 1e-3)
        assertEquals(robot.leftWheelTurn, robot.rightWheelTurn, 1e-9)
    }

    @Test
    fun `a robot that floats rolls further than one that brakes`() = runTest {
        fun program(mode: Int) = ScriptedProgram {
            motors(ScriptedProgram.FORWARD, 3)
            pause(500)
            motors(mode, 7)
            pause(1000)
        }
        val braking = runToEnd(program(ScriptedProgram.BRAKE)).state.robot.pose.x - start.x
        val floating = runToEnd(program(ScriptedProgram.FLOAT)).state.robot.pose.x - start.x
        assertEquals(10.0, braking, 0.2)
        assertTrue(floating > braking + 2, "braking $braking, floating $floating")
    }

    @Test
    fun `more power is faster`() {
        val speeds = (0..7).map(RcxMotor(RobotParameters.PENBOT)::drivenSpeed)
        assertEquals(speeds.sorted().distinct(), speeds)
        assertEquals(Penbot.CALIBRATED_SPEED, speeds[Penbot.CALIBRATED_POWER])
        assertEquals(Penbot.TOP_SPEED, speeds.last(), 1e-9)
    }
}
