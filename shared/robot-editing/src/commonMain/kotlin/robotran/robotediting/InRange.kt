package robotran.robotediting

import robotran.brick.kind.WheelTrim
import robotran.world.BuggyMount
import robotran.world.BumperPart
import robotran.world.Drive
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.RobotLimits
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.robot.rounded
import robotran.world.roundToThousandths

/**
 * The robot with every figure that differs from [before] in its range and rounded as in a file. What has not changed
 * stays as it is, since the figures of ready robots need not be round.
 */
internal fun RobotDescription.inRange(before: RobotDescription): RobotDescription = copy(
    title = title.filterNot { it.isISOControl() }.take(RobotLimits.MAXIMUM_TITLE_CHARACTERS).trimStart()
        .ifBlank { before.title },
    chassis = if (chassis == before.chassis) {
        chassis
    } else {
        chassis.copy(
            outline = chassis.outline.map { it.inRange() },
            height = chassis.height.within(RobotLimits.HEIGHTS, before.chassis.height),
            mass = chassis.mass.within(RobotLimits.MASSES, before.chassis.mass),
            massAt = chassis.massAt.inRange(),
        )
    },
    drive = drive.inRange(before.drive),
    casters = if (casters == before.casters) casters else casters.map { it.inRange() },
    brickAt = if (brickAt == before.brickAt) brickAt else brickAt.copy(at = brickAt.at.inRange()),
    buggy = if (buggy == before.buggy) buggy else buggy?.inRange(),
    parts = if (parts == before.parts) parts else parts.map { if (it in before.parts) it else it.inRange() },
)

private fun BuggyMount.inRange() = copy(
    trim = WheelTrim(
        roundToThousandths(trim.left.coerceIn(BuggyMount.TRIMS)),
        roundToThousandths(trim.right.coerceIn(BuggyMount.TRIMS)),
    ),
)

private fun Drive.inRange(before: Drive) = copy(
    wheelDiameter = wheelDiameter.within(RobotLimits.WHEEL_DIAMETERS, before.wheelDiameter),
    wheelWidth = wheelWidth.within(RobotLimits.WHEEL_WIDTHS, before.wheelWidth),
    track = track.within(RobotLimits.TRACKS, before.track),
    gear = gear.within(RobotLimits.GEARS, before.gear),
    tyreFriction = tyreFriction.within(RobotLimits.TYRE_FRICTIONS, before.tyreFriction),
)

internal fun RobotPart.inRange(): RobotPart = when (this) {
    is BumperPart -> copy(
        at = at.inRange(),
        width = width.coerceIn(RobotLimits.BUMPER_WIDTHS),
        depth = depth.coerceIn(RobotLimits.BUMPER_DEPTHS),
        direction = normalAngle(direction),
    )

    is SensorPart -> copy(
        at = at.inRange(),
        height = height.coerceIn(RobotLimits.SENSOR_HEIGHTS),
        facing = (facing as? Facing.Ahead)?.let { Facing.Ahead(normalAngle(it.direction)) } ?: facing,
    )

    else -> this
}.rounded()

private fun Double.within(range: ClosedFloatingPointRange<Double>, before: Double): Double =
    if (this == before) this else roundToThousandths(coerceIn(range))

internal fun Point.inRange() = Point(
    roundToThousandths(x.coerceIn(RobotLimits.COORDINATES)),
    roundToThousandths(y.coerceIn(RobotLimits.COORDINATES)),
)
