package robotran.narration

import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.length
import robotran.world.geometry.normalHeading
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The direction of the vector [x], [y] in (-180, 180] degrees counter-clockwise from the x axis; 0 for no vector. It
 * uses only arithmetic and `sqrt`, so it is the same on every target, which `atan2` is not.
 */
internal fun directionOf(x: Double, y: Double): Double = when {
    x == 0.0 && y == 0.0 -> 0.0
    abs(y) <= abs(x) -> if (x > 0) angleOf(y / x) else normalHeading(angleOf(y / x) + HALF_TURN)
    else -> (if (y > 0) QUARTER_TURN else -QUARTER_TURN) - angleOf(x / y)
}

/** The angle by which a robot at this pose has to turn to look at [point], to the left if it is positive. */
internal fun Pose.turnTo(point: Point): Double = normalHeading(directionOf(point.x - x, point.y - y) - heading)

internal fun Pose.distanceTo(point: Point): Double = length(point.x - x, point.y - y)

internal val Pose.point: Point get() = Point(x, y)

/** The arc tangent in degrees, of at most 1 and at least -1. */
private fun angleOf(tangent: Double): Double {
    var small = tangent
    repeat(HALVINGS) { small /= 1 + sqrt(1 + small * small) }
    var power = small
    var sum = small
    for (number in 1..TERMS) {
        power *= -small * small
        sum += power / (2 * number + 1)
    }
    return sum * (1 shl HALVINGS) * HALF_TURN / PI
}

private const val HALVINGS = 3
private const val TERMS = 8
internal const val HALF_TURN = 180.0
internal const val QUARTER_TURN = 90.0
