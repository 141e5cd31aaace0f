package robotran.ui.sheet

import robotran.uikit.*
import robotran.world.geometry.Point
import kotlin.math.hypot

/** The signed distance of [point] from the polygon with these [corners]: positive outside, negative inside. */
internal fun distanceInto(corners: List<Point>, point: Point): Double =
    distanceToEdge(corners, point).let { if (surrounds(corners, point)) -it else it }

/** Whether a position is inside a polygon, which may be concave. */
internal fun surrounds(corners: List<Point>, point: Point): Boolean {
    var inside = false
    corners.forEachEdge { from, to ->
        val crosses = (from.y > point.y) != (to.y > point.y)
        if (crosses && point.x < (to.x - from.x) * (point.y - from.y) / (to.y - from.y) + from.x) inside = !inside
    }
    return inside
}

/** The distance of a position from the edge of a polygon, from inside or outside. */
internal fun distanceToEdge(corners: List<Point>, point: Point): Double {
    var nearest = Double.MAX_VALUE
    corners.forEachEdge { from, to -> nearest = minOf(nearest, distanceToPiece(from, to, point)) }
    return nearest
}

/** The distance of a position from a polyline through [points]. */
internal fun distanceToLine(points: List<Point>, point: Point): Double = if (points.size == 1) {
    distance(points.single(), point)
} else {
    points.zipWithNext { from, to -> distanceToPiece(from, to, point) }.min()
}

private fun distanceToPiece(from: Point, to: Point, point: Point): Double {
    val alongX = to.x - from.x
    val alongY = to.y - from.y
    val squaredLength = alongX * alongX + alongY * alongY
    if (squaredLength == 0.0) return distance(from, point)
    val part = (((point.x - from.x) * alongX + (point.y - from.y) * alongY) / squaredLength).coerceIn(0.0, 1.0)
    return distance(point, Point(from.x + part * alongX, from.y + part * alongY))
}

fun distance(one: Point, other: Point): Double = hypot(other.x - one.x, other.y - one.y)
