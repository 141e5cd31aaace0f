package robotran.world.robot

import robotran.world.RobotDescription
import robotran.world.geometry.Point
import kotlin.math.abs

/**
 * Where the brick lies on its robot in pictures, which show it a little smaller than it is, so that the tyres are seen.
 *
 * @property middle on the robot.
 * @property upperEnd the direction of its upper end, where an NXT has its motor ports and an RCX its inputs: 0 ahead, 90
 * to the left, 180 or 270.
 * @property width in centimetres, from its left to its right.
 * @property length in centimetres, from its upper to its lower end.
 */
data class BrickSeat(val middle: Point, val upperEnd: Int, val width: Double, val length: Double) {
    /** Whether it lies along the robot, not across. */
    val isAlong: Boolean get() = upperEnd % HALF_TURN == 0

    /** Half of what it covers along the robot. */
    val halfAlong: Double get() = (if (isAlong) length else width) / 2

    /** Half of what it covers across the robot. */
    val halfAcross: Double get() = (if (isAlong) width else length) / 2
}

/**
 * The brick lies along the robot with its upper end ahead. Where it would cover the pen, it lies across in front of it,
 * with its upper end to the left.
 */
val RobotDescription.brickSeat: BrickSeat
    get() {
        val at = brickAt.at
        val turned = if (brickAt.turned) HALF_TURN else 0
        val build = BrickBuild.of(brick)
        val width = build.seatWidth
        val along = BrickSeat(at, turned, width, build.seatLength)
        val isOverPen = pen != null &&
            abs(at.x) < along.halfAlong + PEN_ROOM && abs(at.y) < along.halfAcross + PEN_ROOM
        if (!isOverPen) return along
        return along.copy(middle = Point(maxOf(at.x, PEN_ROOM + width / 2), at.y), upperEnd = HALF_TURN / 2 + turned)
    }

private const val HALF_TURN = 180

/** Around the tip of the pen, for its clip. */
private const val PEN_ROOM = 1.5
