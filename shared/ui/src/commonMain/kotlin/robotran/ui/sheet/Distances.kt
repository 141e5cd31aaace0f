package robotran.ui.sheet

import robotran.world.geometry.Point
import kotlin.math.hypot

/** The signed distance of [point] from the polygon with these [corners]: positive outside, negative inside. */
internal fun distanceInto(corners: List<Point>, point: Point): Double =
    distanceToEdge(corners, point).let { if (surrounds(corners, point)) -it else it }

/** Whether a position is inside a polygon, which may be concave. */
internal fun surrounds(corners: List<Point>, place: Point): Boolean {
    var inside = false
    corners.forEachEdge { from, to ->
        val crosses = (from.y > place.y) != (to.y > place.y)
        if (crosses && place.x < (to.x - from.x) * (place.y - from.y) / (to.y - from.y) + from.x) inside = !inside
    }
    return inside
}

/** The distance of a position from the edge of a polygon, from inside or outside. */
internal fun distanceToEdge(corners: List<Point>, place: Point): Double {
    var nearest = Double.MAX_VALUE
    corners.forEachEdge { from, to -> nearest = minOf(nearest, distanceToPiece(from, to, place)) }
    return nearest
}

/** The distance of a position from a polyline through [points]. */
internal fun distanceToLine(points: List<Point>, place: Point): Double = if (points.size == 1) {
    distance(points.single(), place)
} else {
    points.zipWithNext { from, to -> distanceToPiece(from, to, place) }.min()
}

private fun distanceToPiece(from: Point, to: Point, place: Point): Double {
    val alongX = to.x - from.x
    val alongY = to.y - from.y
    val squaredLength = alongX * alongX + alongY * alongY
    if (squaredLength == 0.0) return distance(from, place)
    val part = (((place.x - from.x) * alongX + (place.y - from.y) * alongY) / squaredLength).coerceIn(0.0, 1.0)
    return distance(place, Point(from.x + part * alongX, from.y + part * alongY))
}

internal fun distance(one: Point, other: Point): Double = hypot(other.x - one.x, other.y - one.y)
