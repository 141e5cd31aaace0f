package robotran.world.file

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.json.JsonCursor
import robotran.world.BrickMount
import robotran.world.BumperPart
import robotran.world.Chassis
import robotran.world.Drive
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.PenMount
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.messages.sentence
import robotran.world.messages.told
import robotran.world.messages.toldOfRobot
import robotran.world.robot.RobotError
import robotran.world.robot.RobotPiece
import robotran.world.robot.robotErrors
import robotran.world.robot.rounded
import robotran.world.roundToThousandths

/**
 * The robot in the members of [place]; those that are missing are like those of the ready robot that it names.
 *
 * @param mayBeImpossible whether somebody still works on it; its figures are in their ranges nevertheless.
 */
internal fun readDescription(place: JsonCursor, mayBeImpossible: Boolean = false): RobotDescription {
    val base = place.optional("like")?.let(::readyRobot)
    val brick = place.optional("brick")?.choice(BRICKS) ?: base?.brick ?: BrickKind.DEFAULT
    val like = base ?: ReadyRobots.defaultOf(brick)
    val robot = RobotDescription(
        title = place.member("title").text(RobotLimits.MAXIMUM_TITLE_CHARACTERS),
        brick = brick,
        chassis = readChassis(place, like.chassis),
        drive = place.optional("wheels")?.let { readDrive(it, like.drive) } ?: like.drive,
        casters = place.optional("casters")?.items(0..RobotLimits.MAXIMUM_CASTERS)?.map(::readPoint) ?: like.casters,
        pen = if (place.has("pen")) readPen(place.member("pen")) else like.pen,
        brickAt = BrickMount(
            place.optional("brickAt")?.let(::readPoint) ?: like.brickAt.at,
            place.optional("brickTurned")?.flag() ?: like.brickAt.turned,
        ),
        parts =
            place.optional("parts")?.items(0..RobotLimits.MAXIMUM_PARTS)?.map { readPart(it).rounded() } ?: like.parts,
        base = base?.base,
        unknown = unknownOf(place),
    )
    val errors = robotErrors(robot).filter {
        !mayBeImpossible || it is RobotError.OutOfRange ||
            it == RobotError.NoWheels
    }
    errors.firstOrNull()?.let { error -> placeOf(error, place).refuseInSentence { error.sentence(it) } }
    return robot
}

/** The ready robot whose name is at [place]. */
internal fun readyRobot(place: JsonCursor): RobotDescription {
    val name = place.text(RobotLimits.MAXIMUM_TITLE_CHARACTERS)
    return ReadyRobots.all[name]
        ?: place.refuseInSentence(toldOfRobot { noReadyRobot(name, ReadyRobots.all.keys.toList()) })
}

private fun readChassis(place: JsonCursor, like: Chassis): Chassis {
    val mass = place.optional("massAt")?.let(::readPoint)
    return Chassis(
        outline = place.optional("outline")?.items(RobotLimits.CORNERS)?.map(::readPoint) ?: like.outline,
        height = place.optional("height")?.figure(RobotLimits.HEIGHTS) ?: like.height,
        mass = place.optional("mass")?.figure(RobotLimits.MASSES) ?: like.mass,
        massAt = mass ?: like.massAt,
    )
}

private fun readDrive(place: JsonCursor, like: Drive) = Drive(
    wheelDiameter = place.optional("diameter")?.let(::readDiameter) ?: like.wheelDiameter,
    wheelWidth = place.optional("width")?.figure(RobotLimits.WHEEL_WIDTHS) ?: like.wheelWidth,
    track = place.optional("track")?.figure(RobotLimits.TRACKS) ?: like.track,
    gear = place.optional("gear")?.figure(RobotLimits.GEARS) ?: like.gear,
    left = place.optional("left")?.choice(MOTORS) ?: like.left,
    right = place.optional("right")?.choice(MOTORS) ?: like.right,
    reversed = place.optional("reversed")?.flag() ?: like.reversed,
    tyreFriction = place.optional("grip")?.figure(RobotLimits.TYRE_FRICTIONS) ?: like.tyreFriction,
)

private fun readDiameter(place: JsonCursor): Double {
    val diameter = place.number(ANY_NUMBER)
    if (diameter !in RobotLimits.WHEEL_DIAMETERS) place.refuseInSentence(toldOfRobot { noWheels() })
    return roundToThousandths(diameter)
}

private fun readPen(place: JsonCursor): PenMount? = if (place.isNull) null else PenMount(place.choice(MOTORS))

private fun readPart(place: JsonCursor): RobotPart {
    val kind = place.member("kind").choice(PART_KINDS)
    val port = place.optional("port")?.wholeNumber(1..BrickKind.entries.maxOf { it.inputPorts })
    return when (kind) {
        PartKind.BUMPER -> BumperPart(
            port,
            at = readPoint(place.member("at")),
            width = place.member("width").figure(RobotLimits.BUMPER_WIDTHS),
            depth = place.optional("depth")?.figure(RobotLimits.BUMPER_DEPTHS) ?: BumperPart.DEFAULT_DEPTH,
            direction = place.optional("direction")?.figure(RobotLimits.ANGLES) ?: 0.0,
            side = place.optional("side")?.choice(SIDES),
            unknown = unknownOf(place),
        )

        PartKind.TOUCH -> FingerTouchPart(port, unknownOf(place))
        PartKind.ROTATION -> RotationPart(port, place.member("wheel").choice(SIDES), unknownOf(place))
        else -> readSensor(place, port, checkNotNull(kind.sensor))
    }
}

private fun readSensor(place: JsonCursor, port: Int?, sensor: SensorKind): SensorPart {
    val facing = place.optional("facing")?.let(::readFacing) ?: defaultFacing(sensor)
    return SensorPart(
        port,
        sensor,
        at = readPoint(place.member("at")),
        height = place.optional("height")?.figure(RobotLimits.SENSOR_HEIGHTS) ?: defaultHeight(facing),
        facing = facing,
        turret = place.optional("turret")?.choice(MOTORS),
        unknown = unknownOf(place),
    )
}

private fun readFacing(place: JsonCursor): Facing = if (place.textOrNull() != null) {
    place.choice(DIRECTIONS)
} else {
    Facing.Ahead(place.figure(RobotLimits.ANGLES))
}

internal fun defaultFacing(sensor: SensorKind): Facing = when (sensor) {
    SensorKind.LIGHT -> Facing.Free
    SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR, SensorKind.RCX_LIGHT -> Facing.Down
    else -> Facing.Ahead(0.0)
}

/** In centimetres. */
internal fun defaultHeight(facing: Facing): Double = if (facing is Facing.Ahead) AHEAD_HEIGHT else DOWN_HEIGHT

private fun readPoint(place: JsonCursor): Point {
    val coordinates = place.items(0..Int.MAX_VALUE)
    if (coordinates.size != 2) place.refuse(told { mustBePlace() })
    return Point(coordinates[0].figure(RobotLimits.COORDINATES), coordinates[1].figure(RobotLimits.COORDINATES))
}

/** A robot's figures have three decimals at most. */
private fun JsonCursor.figure(range: ClosedRange<Double>): Double =
    roundToThousandths(number(range)).coerceIn(range.start, range.endInclusive)

/** The part of the file that is wrong; the robot itself if the file does not have it. */
private fun placeOf(error: RobotError, robot: JsonCursor): JsonCursor {
    val part = error.part
    return if (part != null) {
        robot.optional("parts")?.items(0..Int.MAX_VALUE)?.getOrNull(part)
    } else {
        MEMBERS.getValue(error.piece).firstNotNullOfOrNull { robot.optional(it) }
    } ?: robot
}

/** The members of a file that may be wrong. */
private val MEMBERS: Map<RobotPiece, List<String>> = RobotPiece.entries.associateWith {
    when (it) {
        RobotPiece.OUTLINE -> listOf("outline")
        RobotPiece.HEIGHT -> listOf("height")
        RobotPiece.MASS -> listOf("massAt", "mass")
        RobotPiece.WHEELS -> listOf("wheels")
        RobotPiece.CASTERS -> listOf("casters", "massAt")
        RobotPiece.PEN -> listOf("pen", "wheels")
        RobotPiece.BRICK -> listOf("brickAt")
        RobotPiece.PART, RobotPiece.ALL -> listOf("parts")
    }
}

private val ANY_NUMBER = -Double.MAX_VALUE..Double.MAX_VALUE
private const val DOWN_HEIGHT = 1.0
private const val AHEAD_HEIGHT = 6.0
