package robotran.world.file

import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.json.JsonCursor
import robotran.world.BrickMount
import robotran.world.BuggyMount
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
import robotran.world.messages.reason
import robotran.world.messages.robotReason
import robotran.world.messages.sentence
import robotran.world.robot.RobotError
import robotran.world.robot.RobotPiece
import robotran.world.robot.robotErrors
import robotran.world.robot.rounded
import robotran.world.roundToThousandths

/**
 * The robot in the members of [cursor]; those that are missing are like those of the ready robot that it names.
 *
 * @param mayBeImpossible whether somebody still works on it; its figures are in their ranges nevertheless.
 */
internal fun readDescription(cursor: JsonCursor, mayBeImpossible: Boolean = false): RobotDescription {
    val base = cursor.optional("like")?.let(::readyRobot)
    val brick = cursor.optional("brick")?.choice(BRICKS) ?: base?.brick ?: BrickKind.default
    val like = base ?: ReadyRobots.defaultOf(brick)
    val robot = RobotDescription(
        title = cursor.member("title").text(RobotLimits.MAXIMUM_TITLE_CHARACTERS),
        brick = brick,
        chassis = readChassis(cursor, like.chassis),
        drive = cursor.optional("wheels")?.let { readDrive(it, like.drive) } ?: like.drive,
        casters = cursor.optional("casters")?.items(0..RobotLimits.MAXIMUM_CASTERS)?.map(::readPoint) ?: like.casters,
        pen = if (cursor.has("pen")) readPen(cursor.member("pen")) else like.pen,
        brickAt = BrickMount(
            cursor.optional("brickAt")?.let(::readPoint) ?: like.brickAt.at,
            cursor.optional("brickTurned")?.flag() ?: like.brickAt.turned,
        ),
        parts =
            cursor.optional("parts")?.items(0..RobotLimits.MAXIMUM_PARTS)?.map { readPart(it).rounded() } ?: like.parts,
        buggy = cursor.optional("buggy")?.let { readBuggy(it, brick.isOnBuggy) } ?: usualBuggy(brick, like),
        base = base?.base,
        unknown = unknownOf(cursor),
    )
    val errors = robotErrors(robot).filter {
        !mayBeImpossible || it is RobotError.OutOfRange ||
            it == RobotError.NoWheels
    }
    errors.firstOrNull()?.let { error -> placeOf(error, cursor).refuseInSentence { error.sentence(it) } }
    return robot
}

/** The buggy of a robot whose file names none: each micro:bit is on one, also if the robot is [like] one without. */
private fun usualBuggy(brick: BrickKind, like: RobotDescription): BuggyMount? =
    if (brick.isOnBuggy) like.buggy ?: ReadyRobots.defaultOf(brick).buggy else null

/** The ready robot whose name is at [cursor]. */
internal fun readyRobot(cursor: JsonCursor): RobotDescription {
    val name = cursor.text(RobotLimits.MAXIMUM_TITLE_CHARACTERS)
    return ReadyRobots.all[name]
        ?: cursor.refuseInSentence(robotReason { noReadyRobot(name, ReadyRobots.all.keys.toList()) })
}

private fun readChassis(cursor: JsonCursor, like: Chassis): Chassis {
    val mass = cursor.optional("massAt")?.let(::readPoint)
    return Chassis(
        outline = cursor.optional("outline")?.items(RobotLimits.CORNERS)?.map(::readPoint) ?: like.outline,
        height = cursor.optional("height")?.figure(RobotLimits.HEIGHTS) ?: like.height,
        mass = cursor.optional("mass")?.figure(RobotLimits.MASSES) ?: like.mass,
        massAt = mass ?: like.massAt,
    )
}

private fun readDrive(cursor: JsonCursor, like: Drive) = Drive(
    wheelDiameter = cursor.optional("diameter")?.let(::readDiameter) ?: like.wheelDiameter,
    wheelWidth = cursor.optional("width")?.figure(RobotLimits.WHEEL_WIDTHS) ?: like.wheelWidth,
    track = cursor.optional("track")?.figure(RobotLimits.TRACKS) ?: like.track,
    gear = cursor.optional("gear")?.figure(RobotLimits.GEARS) ?: like.gear,
    left = cursor.optional("left")?.choice(MOTORS) ?: like.left,
    right = cursor.optional("right")?.choice(MOTORS) ?: like.right,
    reversed = cursor.optional("reversed")?.flag() ?: like.reversed,
    tyreFriction = cursor.optional("grip")?.figure(RobotLimits.TYRE_FRICTIONS) ?: like.tyreFriction,
)

private fun readDiameter(cursor: JsonCursor): Double {
    val diameter = cursor.number(ANY_NUMBER)
    if (diameter !in RobotLimits.WHEEL_DIAMETERS) cursor.refuseInSentence(robotReason { noWheels() })
    return roundToThousandths(diameter)
}

private fun readPen(cursor: JsonCursor): PenMount? = if (cursor.isNull) null else PenMount(cursor.choice(MOTORS))

private fun readPart(cursor: JsonCursor): RobotPart {
    val kind = cursor.member("kind").choice(PART_KINDS)
    val port = cursor.optional("port")?.wholeNumber(1..BrickKind.entries.maxOf { it.inputPorts })
    return when (kind) {
        PartKind.BUMPER -> BumperPart(
            port,
            at = readPoint(cursor.member("at")),
            width = cursor.member("width").figure(RobotLimits.BUMPER_WIDTHS),
            depth = cursor.optional("depth")?.figure(RobotLimits.BUMPER_DEPTHS) ?: BumperPart.DEFAULT_DEPTH,
            direction = cursor.optional("direction")?.figure(RobotLimits.ANGLES) ?: 0.0,
            side = cursor.optional("side")?.choice(SIDES),
            unknown = unknownOf(cursor),
        )

        PartKind.TOUCH -> FingerTouchPart(port, unknownOf(cursor))
        PartKind.ROTATION -> RotationPart(port, cursor.member("wheel").choice(SIDES), unknownOf(cursor))
        else -> readSensor(cursor, port, checkNotNull(kind.sensor))
    }
}

private fun readSensor(cursor: JsonCursor, port: Int?, sensor: SensorKind): SensorPart {
    val facing = cursor.optional("facing")?.let(::readFacing) ?: defaultFacing(sensor)
    return SensorPart(
        port,
        sensor,
        at = readPoint(cursor.member("at")),
        height = cursor.optional("height")?.figure(RobotLimits.SENSOR_HEIGHTS) ?: defaultHeight(facing),
        facing = facing,
        turret = cursor.optional("turret")?.choice(MOTORS),
        unknown = unknownOf(cursor),
    )
}

private fun readFacing(cursor: JsonCursor): Facing = if (cursor.textOrNull() != null) {
    cursor.choice(DIRECTIONS)
} else {
    Facing.Ahead(cursor.figure(RobotLimits.ANGLES))
}

internal fun defaultFacing(sensor: SensorKind): Facing = when (sensor) {
    SensorKind.LIGHT -> Facing.Free
    SensorKind.COLOUR, SensorKind.HITECHNIC_COLOUR, SensorKind.RCX_LIGHT -> Facing.Down
    else -> Facing.Ahead(0.0)
}

/** In centimetres. */
internal fun defaultHeight(facing: Facing): Double = if (facing is Facing.Ahead) AHEAD_HEIGHT else DOWN_HEIGHT

private fun readPoint(cursor: JsonCursor): Point {
    val coordinates = cursor.items(0..Int.MAX_VALUE)
    if (coordinates.size != 2) cursor.refuse(reason { mustBePlace() })
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
