package robotran.world.robot

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.pluggedSensors
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class UsualPartsTest {
    @Test
    fun `a penbot gets its own sensors`() {
        val bare = ReadyRobots.penbotWith(List(3) { emptyList() })

        fun on(port: Int, kind: SensorKind) = bare.withSensor(kind, port).pluggedSensors[port - 1]
        assertEquals(listOf(PortSensor.LEFT_BUMPER), on(1, SensorKind.TOUCH))
        assertEquals(listOf(PortSensor.LEFT_BUMPER, PortSensor.RIGHT_BUMPER), on(2, SensorKind.TOUCH))
        assertEquals(listOf(PortSensor.RIGHT_BUMPER), on(3, SensorKind.TOUCH))
        assertEquals(listOf(PortSensor.RIGHT_ROTATION), on(3, SensorKind.ROTATION))
        assertEquals(
            ReadyRobots.RCX_PENBOT,
            listOf(1 to SensorKind.TOUCH, 2 to SensorKind.LIGHT, 3 to SensorKind.TOUCH)
                .fold(bare) { robot, (port, kind) -> robot.withSensor(kind, port) },
        )
    }

    @Test
    fun `what a brick can read can be plugged into every port of every ready robot`() {
        for ((name, robot) in ReadyRobots.all) {
            for (kind in robot.brick.sensors) {
                for (port in (1..robot.brick.inputPorts).filterNot { hasMotor(robot, it) }) {
                    val plugged = robot.withSensor(kind, port)
                    assertEquals(emptyList(), robotErrors(plugged), "$kind on $port of $name")
                    assertTrue(plugged.parts.any { it.port == port && it.kind == kind }, "$kind on $port of $name")
                }
            }
        }
    }

    /** Whether a motor is on the port with this number, which has a letter. */
    private fun hasMotor(robot: RobotDescription, port: Int): Boolean = robot.brick.hasLetteredInputs &&
        listOf(robot.drive.left, robot.drive.right, robot.pen?.motor).any { it?.ordinal == port - 1 }

    @Test
    fun `a bumper that makes room for something else stays on the robot`() {
        val robot = ReadyRobots.NXT_PENBOT.withSensor(SensorKind.SOUND, 1)
        assertEquals(2, robot.bumpers.size)
        assertEquals(robot.bumpers, robot.withSensor(SensorKind.TOUCH, 3).bumpers)
        assertEquals(BrickKind.NXT, robot.brick)
    }
}
