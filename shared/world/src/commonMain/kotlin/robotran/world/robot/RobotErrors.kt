package robotran.world.robot

import robotran.brick.controls.MotorPort
import robotran.world.BumperPart
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.SensorPart
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.edgesCross
import robotran.world.geometry.side
import robotran.world.isSameThing
import robotran.world.robot.RobotError.OutOfRange
import kotlin.math.abs

/** Why [robot] is impossible; empty if it can be built. The reader of files and the workbench tell the first. */
fun robotErrors(robot: RobotDescription): List<RobotError> {
    val ranges = rangeErrors(robot)
    // The other checks need figures within their ranges.
    if (ranges.isNotEmpty()) return ranges
    return outlineErrors(robot) + driveErrors(robot) + balanceErrors(robot) + plugErrors(robot) + partErrors(robot)
}

private fun rangeErrors(robot: RobotDescription): List<RobotError> = buildList {
    fun check(value: Double, range: ClosedRange<Double>, piece: RobotPiece, figure: RobotParameter, part: Int? = null) {
        if (value !in range) add(OutOfRange(piece, figure, range, part))
    }

    fun check(point: Point, piece: RobotPiece, part: Int? = null) {
        check(point.x, RobotLimits.COORDINATES, piece, RobotParameter.COORDINATE, part)
        check(point.y, RobotLimits.COORDINATES, piece, RobotParameter.COORDINATE, part)
    }

    fun check(count: Int, counts: IntRange, piece: RobotPiece, figure: RobotParameter) =
        check(count.toDouble(), counts.first.toDouble()..counts.last.toDouble(), piece, figure)
    check(robot.chassis.outline.size, RobotLimits.CORNERS, RobotPiece.OUTLINE, RobotParameter.CORNERS)
    robot.chassis.outline.forEach { check(it, RobotPiece.OUTLINE) }
    check(robot.chassis.height, RobotLimits.HEIGHTS, RobotPiece.HEIGHT, RobotParameter.HEIGHT)
    check(robot.chassis.mass, RobotLimits.MASSES, RobotPiece.MASS, RobotParameter.MASS)
    check(robot.chassis.massAt, RobotPiece.MASS)
    if (robot.drive.wheelDiameter !in RobotLimits.WHEEL_DIAMETERS) add(RobotError.NoWheels)
    check(robot.drive.wheelWidth, RobotLimits.WHEEL_WIDTHS, RobotPiece.WHEELS, RobotParameter.WHEEL_WIDTH)
    check(robot.drive.track, RobotLimits.TRACKS, RobotPiece.WHEELS, RobotParameter.TRACK)
    check(robot.drive.gear, RobotLimits.GEARS, RobotPiece.WHEELS, RobotParameter.GEAR)
    check(robot.drive.tyreFriction, RobotLimits.TYRE_FRICTIONS, RobotPiece.WHEELS, RobotParameter.TYRE_FRICTION)
    check(robot.casters.size, 0..RobotLimits.MAXIMUM_CASTERS, RobotPiece.CASTERS, RobotParameter.CASTERS)
    robot.casters.forEach { check(it, RobotPiece.CASTERS) }
    check(robot.brickAt.at, RobotPiece.BRICK)
    check(robot.parts.size, 0..RobotLimits.MAXIMUM_PARTS, RobotPiece.ALL, RobotParameter.PARTS)
    robot.parts.forEachIndexed { number, part ->
        when (part) {
            is BumperPart -> {
                check(part.at, RobotPiece.PART, number)
                check(part.width, RobotLimits.BUMPER_WIDTHS, RobotPiece.PART, RobotParameter.BUMPER_WIDTH, number)
                check(part.depth, RobotLimits.BUMPER_DEPTHS, RobotPiece.PART, RobotParameter.BUMPER_DEPTH, number)
                check(part.direction, RobotLimits.ANGLES, RobotPiece.PART, RobotParameter.ANGLE, number)
            }

            is SensorPart -> {
                check(part.at, RobotPiece.PART, number)
                check(part.height, RobotLimits.SENSOR_HEIGHTS, RobotPiece.PART, RobotParameter.SENSOR_HEIGHT, number)
                check(part.towards, RobotLimits.ANGLES, RobotPiece.PART, RobotParameter.ANGLE, number)
            }

            else -> Unit
        }
    }
}

private fun outlineErrors(robot: RobotDescription): List<RobotError> {
    val outline = robot.chassis.outline
    val sides = RobotLimits.OUTLINE_SIDES
    val lengths = listOf(outline.along, outline.across)
    return when {
        lengths.any { it < sides.start } -> listOf(RobotError.OutlineTooSmall)
        lengths.any { it > sides.endInclusive } -> listOf(RobotError.OutlineTooLarge)
        edgesCross(outline) -> listOf(RobotError.OutlineCrosses)
        shapes(robot) > RobotLimits.MAXIMUM_SHAPES -> listOf(RobotError.TooManyCorners)
        else -> emptyList()
    }
}

/** At most as many convex shapes make up the robot: the physics may need fewer for the chassis. */
private fun shapes(robot: RobotDescription): Int {
    val corners = robot.chassisCorners
    val dents = corners.indices.count {
        side(corners[it], corners[(it + 1) % corners.size], corners[(it + 2) % corners.size]) < 0
    }
    val chassis = if (dents == 0) 1 else corners.size - 2
    return chassis + WHEELS + robot.bumpers.size
}

private fun driveErrors(robot: RobotDescription): List<RobotError> {
    val drive = robot.drive
    val speed = RobotParameters.of(robot).topSpeed
    return motorErrors(robot) + listOfNotNull(
        RobotError.OneDriveMotor(drive.left).takeIf { drive.left == drive.right },
        robot.pen?.motor?.takeIf { it == drive.left || it == drive.right }?.let { RobotError.PenMotorTaken(it) },
        RobotError.WheelsTooClose.takeIf { drive.track <= drive.wheelWidth },
        RobotError.TooFast.takeIf { speed > RobotLimits.FASTEST },
    )
}

/** Motors for which the brick has no port, or whose port with a letter has a sensor. */
private fun motorErrors(robot: RobotDescription): List<RobotError> {
    val brick = robot.brick
    val sensors = if (brick.hasLetteredInputs) robot.parts.mapNotNull { it.port } else emptyList()

    fun isFree(motor: MotorPort) = motor in brick.motorPorts && motor.ordinal + 1 !in sensors
    val wheels = listOf(robot.drive.left, robot.drive.right).map { RobotPiece.WHEELS to it }
    val pens = listOfNotNull(robot.pen?.motor).map { RobotPiece.PEN to it }
    return (wheels + pens).filterNot { isFree(it.second) }.map { RobotError.NoSuchMotor(it.first, brick, it.second) }
}

private fun balanceErrors(robot: RobotDescription): List<RobotError> {
    val mass = robot.chassis.massAt
    val onAxle = robot.casters.any { abs(it.x) < RobotLimits.NEAREST_CASTER }
    val caster = robot.supportingCaster
    val tips = mass.x != 0.0 && (caster == null || abs(mass.x) >= abs(caster.x))
    return listOfNotNull(
        RobotError.MassBesideMiddle.takeIf { mass.y != 0.0 },
        RobotError.MassOutside.takeIf { !Outline.Angular(robot.chassisCorners).contains(mass.x, mass.y) },
        RobotError.CasterOnAxle.takeIf { onAxle },
        RobotError.TipsOver(mass.x < 0).takeIf { !onAxle && tips },
    )
}

private fun plugErrors(robot: RobotDescription): List<RobotError> {
    return robot.parts.mapIndexedNotNull { number, part ->
        val port = part.port ?: return@mapIndexedNotNull null
        val before = robot.parts.take(number).filter { it.port == port }
        when {
            port !in 1..robot.brick.inputPorts -> RobotError.NoSuchPort(number, robot.brick, port)
            part.kind !in robot.brick.sensors -> RobotError.UnreadableSensor(number, robot.brick, part.kind)
            before.size >= robot.brick.sensorsOnPort || before.any {
                it.isSameThing(part)
            } -> RobotError.PortTaken(number, port)
            else -> null
        }
    }
}

private const val WHEELS = 2
