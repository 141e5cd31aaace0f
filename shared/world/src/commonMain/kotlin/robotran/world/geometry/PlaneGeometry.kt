package robotran.world.geometry

import kotlin.math.sqrt

/** The same direction in (-180, 180] degrees; [degrees] may be up to a full turn. */
fun normalHeading(degrees: Double): Double = when {
    degrees > HALF_TURN -> degrees - FULL_TURN
    degrees <= -HALF_TURN -> degrees + FULL_TURN
    else -> degrees
}

/** Distance of [point] from the segment between [from] and [to]. */
fun distance(point: Point, from: Point, to: Point): Double {
    val alongX = to.x - from.x
    val alongY = to.y - from.y
    val squaredLength = alongX * alongX + alongY * alongY
    val share = if (squaredLength == 0.0) {
        0.0
    } else {
        ((point.x - from.x) * alongX + (point.y - from.y) * alongY) / squaredLength
    }
    val nearest = share.coerceIn(0.0, 1.0)
    return length(point.x - from.x - nearest * alongX, point.y - from.y - nearest * alongY)
}

/** Positive if [point] is to the left of the line from [from] to [to], zero if it is on it. */
internal fun side(from: Point, to: Point, point: Point): Double =
    (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x)

/** Whether two segments cross at inner points. */
fun cross(from: Point, to: Point, otherFrom: Point, otherTo: Point): Boolean =
    side(from, to, otherFrom) * side(from, to, otherTo) < 0 &&
        side(otherFrom, otherTo, from) * side(otherFrom, otherTo, to) < 0

/** Not `hypot`, because platforms may round it differently; `sqrt` is exact everywhere. */
fun length(x: Double, y: Double): Double = sqrt(x * x + y * y)

private const val FULL_TURN = 360.0
private const val HALF_TURN = 180.0
