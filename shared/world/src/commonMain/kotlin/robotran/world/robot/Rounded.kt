package robotran.world.robot

import robotran.brick.kind.WheelTrim
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.geometry.Point
import robotran.world.roundToThousandths

/** The same robot with at most three decimals in each figure, as an editor makes it and a file keeps it. */
fun RobotDescription.rounded(): RobotDescription = copy(
    chassis = chassis.copy(
        outline = chassis.outline.map { it.rounded() },
        height = roundToThousandths(chassis.height),
        mass = roundToThousandths(chassis.mass),
        massAt = chassis.massAt.rounded(),
    ),
    drive = drive.copy(
        wheelDiameter = roundToThousandths(drive.wheelDiameter),
        wheelWidth = roundToThousandths(drive.wheelWidth),
        track = roundToThousandths(drive.track),
        gear = roundToThousandths(drive.gear),
        tyreFriction = roundToThousandths(drive.tyreFriction),
    ),
    casters = casters.map { it.rounded() },
    brickAt = brickAt.copy(at = brickAt.at.rounded()),
    parts = parts.map { it.rounded() },
    buggy = buggy?.let { it.copy(trim = it.trim.rounded()) },
)

/** A part that is one of the penbot's but for its rounding is that part. */
fun RobotPart.rounded(): RobotPart {
    val inThousandths = inThousandths()
    return PENBOT_PARTS[inThousandths.on(null)]?.on(port) ?: inThousandths
}

private fun RobotPart.inThousandths(): RobotPart = when (this) {
    is BumperPart -> copy(
        at = at.rounded(),
        width = roundToThousandths(width),
        depth = roundToThousandths(depth),
        direction = roundToThousandths(direction),
    )

    is SensorPart -> copy(
        at = at.rounded(),
        height = roundToThousandths(height),
        facing = (facing as? Facing.Ahead)?.let { Facing.Ahead(roundToThousandths(it.direction)) } ?: facing,
    )

    is FingerTouchPart, is RotationPart -> this
}

/** The penbot's parts, by what they are when they are rounded. */
private val PENBOT_PARTS: Map<RobotPart, RobotPart> =
    ReadyRobots.RCX_PENBOT.parts.map { it.on(null) }.associateBy { it.inThousandths() }

private fun WheelTrim.rounded() = WheelTrim(roundToThousandths(left), roundToThousandths(right))

private fun Point.rounded() = Point(roundToThousandths(x), roundToThousandths(y))
