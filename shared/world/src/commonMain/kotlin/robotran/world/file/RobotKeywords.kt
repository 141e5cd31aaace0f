package robotran.world.file

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.world.BumperSide
import robotran.world.Facing

/** The words for the parts of a robot in a file; [sensor] of those that are no more than a sensor. */
internal enum class PartKind(val sensor: SensorKind?) {
    BUMPER(null),
    TOUCH(null),
    LIGHT(SensorKind.LIGHT),
    ROTATION(null),
    TEMPERATURE(SensorKind.TEMPERATURE),
    ULTRASONIC(SensorKind.ULTRASONIC),
    SOUND(SensorKind.SOUND),
    COLOUR(SensorKind.COLOUR),
    COMPASS(SensorKind.COMPASS),
    GYRO(SensorKind.GYRO),
    HITECHNIC_COLOUR(SensorKind.HITECHNIC_COLOUR),
    MINDSENSORS_COMPASS(SensorKind.MINDSENSORS_COMPASS),
    HITECHNIC_ACCELERATION(SensorKind.HITECHNIC_ACCELERATION),
    MINDSENSORS_ACCELERATION(SensorKind.MINDSENSORS_ACCELERATION),
    RCX_LIGHT(SensorKind.RCX_LIGHT),
    RCX_LINK(SensorKind.RCX_LINK),
    OPTICAL_DISTANCE(SensorKind.OPTICAL_DISTANCE),
    NXT_TEMPERATURE(SensorKind.NXT_TEMPERATURE),
    INFRARED_SEEKER(SensorKind.INFRARED_SEEKER),
    INFRARED_SEEKER_2(SensorKind.INFRARED_SEEKER_2),
}

internal val PART_KINDS: Map<String, PartKind> = PartKind.entries.associateBy { wordFor(it) }
internal val SIDES: Map<String, BumperSide> = BumperSide.entries.associateBy { wordFor(it) }
internal val BRICKS: Map<String, BrickKind> = BrickKind.entries.associateBy { brickWord(it) }

/** What files call a brick, such as `spike-prime`. */
internal fun brickWord(brick: BrickKind): String = wordFor(brick).replace(' ', '-')

internal val DIRECTIONS: Map<String, Facing> = mapOf("down" to Facing.Down, "free" to Facing.Free)

/** Those that any brick has, in capital letters, as on the brick. */
internal val MOTORS: Map<String, MotorPort> =
    MotorPort.entries.filter { port -> BrickKind.entries.any { port in it.motorPorts } }.associateBy { it.name }
