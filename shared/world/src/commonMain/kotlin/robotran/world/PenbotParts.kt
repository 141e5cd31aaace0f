package robotran.world

import robotran.brick.sensors.SensorKind
import robotran.world.geometry.Point

/** The penbot's part for a sensor of the short form, on [port]. */
internal fun penbotPart(sensor: PortSensor, port: Int?): RobotPart = when (sensor) {
    PortSensor.LEFT_BUMPER -> bumper(port, BUMPER_MIDDLE, BumperSide.LEFT)
    PortSensor.RIGHT_BUMPER -> bumper(port, -BUMPER_MIDDLE, BumperSide.RIGHT)
    PortSensor.TOUCH -> FingerTouchPart(port)
    PortSensor.LIGHT -> SensorPart(port, SensorKind.LIGHT, LIGHT_PLACE, LIGHT_HEIGHT, Facing.Free)
    PortSensor.LEFT_ROTATION -> RotationPart(port, BumperSide.LEFT)
    PortSensor.RIGHT_ROTATION -> RotationPart(port, BumperSide.RIGHT)
    PortSensor.TEMPERATURE -> SensorPart(port, SensorKind.TEMPERATURE, WARM_PLACE, WARM_HEIGHT, Facing.Ahead(0.0))
}

/** The parts of a penbot: what is on its ports, then its bumpers and light sensor that are plugged in nowhere. */
internal fun penbotParts(ports: List<List<PortSensor>>): List<RobotPart> {
    val plugged = ports.flatMapIndexed { port, sensors -> sensors.map { it to port + 1 } }
    val loose = MOUNTED.filter { sensor -> plugged.none { it.first == sensor } }.map { it to null }
    return (plugged + loose).map { (sensor, port) -> penbotPart(sensor, port) }
}

/**
 * What is on each port of a robot that is a penbot with any sensors on its ports; null for every other robot. Such a
 * robot is written in the short form.
 */
val RobotDescription.penbotPorts: List<List<PortSensor>>?
    get() {
        if (copy(parts = emptyList()) != ReadyRobots.RCX_PENBOT.copy(parts = emptyList())) return null
        val ports = pluggedSensors
        return ports.takeIf { penbotParts(it) == parts }
    }

/** What is on each port, in the words of the short form; a kind that it does not have is left out. */
val RobotDescription.pluggedSensors: List<List<PortSensor>>
    get() = List(brick.inputPorts) { port -> parts.filter { it.port == port + 1 }.mapNotNull(::sensorOf) }

private fun sensorOf(part: RobotPart): PortSensor? = when (part) {
    is BumperPart -> {
        val isLeft = part.side?.let { it == BumperSide.LEFT } ?: (part.at.y > 0)
        if (isLeft) PortSensor.LEFT_BUMPER else PortSensor.RIGHT_BUMPER
    }

    is FingerTouchPart -> PortSensor.TOUCH
    is RotationPart -> if (part.wheel == BumperSide.LEFT) PortSensor.LEFT_ROTATION else PortSensor.RIGHT_ROTATION

    is SensorPart -> {
        when (part.sensor) {
            SensorKind.LIGHT -> PortSensor.LIGHT
            SensorKind.TEMPERATURE -> PortSensor.TEMPERATURE
            else -> null
        }
    }
}

/**
 * The same robot with these sensors on its ports. A bumper that is taken off a port stays on the robot. Of a robot that
 * is no penbot, only the ports change that are to have something else.
 */
fun RobotDescription.withPlugged(ports: List<List<PortSensor>>): RobotDescription {
    if (penbotPorts != null) return ReadyRobots.penbotWith(ports)
    val before = pluggedSensors
    return ports.foldIndexed(this) { index, robot, wanted ->
        if (wanted == before.getOrNull(index)) robot else robot.withPlugged(index + 1, wanted)
    }
}

private fun RobotDescription.withPlugged(port: Int, sensors: List<PortSensor>): RobotDescription {
    val freed = parts.mapNotNull { part ->
        if (part.port == port) (part as? BumperPart)?.on(null) else part
    }
    return sensors.fold(copy(parts = freed)) { robot, sensor -> robot.plug(sensor, port) }
}

private fun RobotDescription.plug(sensor: PortSensor, port: Int): RobotDescription {
    val loose = parts.indexOfFirst { it.port == null && sensorOf(it) == sensor }
    val known = parts.firstOrNull { sensorOf(it) == sensor }
    return copy(
        parts = when {
            loose >= 0 -> parts.mapIndexed { number, part -> if (number == loose) part.on(port) else part }
            known != null -> parts + known.on(port)
            else -> parts + penbotPart(sensor, port)
        },
    )
}

private fun bumper(port: Int?, middle: Double, side: BumperSide) =
    BumperPart(port, Point(Penbot.BUMPER_FRONT, middle), Penbot.BUMPER_WIDTH, side = side)

private const val BUMPER_MIDDLE = (Penbot.BUMPER_GAP + Penbot.BUMPER_WIDTH) / 2
private val LIGHT_PLACE = Point(Penbot.LIGHT_SENSOR_POSITION, 0.0)
private const val LIGHT_HEIGHT = 1.0
private val WARM_PLACE = Point(-2.5, 0.0)
private const val WARM_HEIGHT = 8.0

/** What is always on a penbot, plugged in or not. */
private val MOUNTED = listOf(PortSensor.LEFT_BUMPER, PortSensor.RIGHT_BUMPER, PortSensor.LIGHT)
