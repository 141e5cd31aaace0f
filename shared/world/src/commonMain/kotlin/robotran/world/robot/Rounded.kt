package robotran.world.robot

import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.FingerTouchPart
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
)

fun RobotPart.rounded(): RobotPart = when (this) {
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

private fun Point.rounded() = Point(roundToThousandths(x), roundToThousandths(y))
