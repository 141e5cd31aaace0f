package robotran.world

import robotran.brick.sensors.SensorKind
import robotran.world.geometry.Point
import robotran.world.robot.robotErrors
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class PenbotPartsTest {
    private val odd = listOf(
        listOf(PortSensor.TOUCH, PortSensor.RIGHT_BUMPER),
        listOf(PortSensor.RIGHT_BUMPER, PortSensor.LIGHT),
        listOf(PortSensor.LIGHT, PortSensor.TOUCH),
    )

    @Test
    fun `sensors stay on their ports in their order`() {
        for (ports in listOf(RobotPlacement.PENBOT_PORTS, odd, List(3) { emptyList() })) {
            val robot = ReadyRobots.penbotWith(ports)
            assertEquals(ports, robot.penbotPorts)
            assertEquals(ports, robot.pluggedSensors)
            assertEquals(emptyList(), robotErrors(robot))
            assertEquals(robot, ReadyRobots.RCX_PENBOT.withPlugged(ports))
        }
    }

    @Test
    fun `a penbot keeps its bumpers and its light sensor when they are unplugged`() {
        val bare = ReadyRobots.penbotWith(List(3) { emptyList() })
        assertEquals(listOf(SensorKind.TOUCH, SensorKind.TOUCH, SensorKind.LIGHT), bare.parts.map { it.kind })
        assertEquals(listOf(null, null, null), bare.parts.map { it.port })
    }

    @Test
    fun `other robots have no short form`() {
        assertNull(ReadyRobots.SUMO.penbotPorts)
        assertNull(ReadyRobots.RCX_PENBOT.copy(title = "Mine").penbotPorts)
        assertNull(ReadyRobots.RCX_PENBOT.copy(parts = emptyList()).penbotPorts)
    }

    @Test
    fun `plugging changes the ports of another robot and nothing else`() {
        val drive = ReadyRobots.RCX_PENBOT.drive.copy(wheelDiameter = 6.0)
        val wide = BumperPart(1, Point(9.2, 0.0), 12.0, side = BumperSide.LEFT)
        val light = SensorPart(2, SensorKind.LIGHT, Point(7.0, 1.0), 1.0, Facing.Down)
        val robot = ReadyRobots.RCX_PENBOT.copy(drive = drive, parts = listOf(wide, light))
        val plugged = robot.withPlugged(listOf(emptyList(), listOf(PortSensor.LIGHT), listOf(PortSensor.LEFT_BUMPER)))
        assertEquals(drive, plugged.drive)
        assertEquals(listOf(wide.copy(port = 3), light), plugged.parts)
        val warm = robot.withPlugged(
            listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.TEMPERATURE), emptyList()),
        )
        assertEquals(listOf(SensorKind.TOUCH, SensorKind.TEMPERATURE), warm.parts.map { it.kind })
    }
}
