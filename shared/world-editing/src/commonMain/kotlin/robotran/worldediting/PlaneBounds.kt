package robotran.worldediting

import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import robotran.world.geometry.length
import robotran.world.geometry.normalHeading

/** The axis-aligned bounding box of [points], which must not be empty. */
internal fun boundsOf(points: List<Point>) =
    Bounds(points.minOf { it.x }, points.minOf { it.y }, points.maxOf { it.x }, points.maxOf { it.y })

/** The axis-aligned bounding box of all [bounds]; null if empty. */
internal fun around(bounds: List<Bounds>): Bounds? = if (bounds.isEmpty()) {
    null
} else {
    Bounds(bounds.minOf { it.left }, bounds.minOf { it.bottom }, bounds.maxOf { it.right }, bounds.maxOf { it.top })
}

val Bounds.middle: Point get() = Point((left + right) / 2, (bottom + top) / 2)
val Bounds.width: Double get() = right - left
val Bounds.height: Double get() = top - bottom

/** Whether all of [other] is inside. */
internal operator fun Bounds.contains(other: Bounds) =
    other.left >= left && other.right <= right && other.bottom >= bottom && other.top <= top

internal fun Bounds.distanceTo(point: Point): Double =
    length(point.x - point.x.coerceIn(left, right), point.y - point.y.coerceIn(bottom, top))

/** Normalizes an angle to (-180, 180] degrees. */
internal fun normalizedAngle(degrees: Double): Double = normalHeading(degrees.rem(FULL_TURN))

private const val FULL_TURN = 360.0
