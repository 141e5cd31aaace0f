package robotran.ui.sheet

import robotran.world.Point
import robotran.world.Shape
import robotran.world.centre
import kotlin.math.hypot

/**
 * A place in [shape] that is far from its edge, where something can be written, and how far that is: the centre of a circle or rectangle, and of
 * a polygon, which may be dented, the best of a grid of places.
 */
internal fun roomiestPlace(shape: Shape): Pair<Point, Double> = when (shape) {
    is Shape.Circle -> shape.centre to shape.radius
    is Shape.Rectangle -> shape.centre to minOf(shape.width, shape.height) / 2
    is Shape.Polygon -> roomiestPlace(shape)
}

/** Of places as good as each other, the one nearest to the middle of them all. */
private fun roomiestPlace(shape: Shape.Polygon): Pair<Point, Double> {
    val centre = shape.centre
    val left = shape.corners.minOf { it.x }
    val bottom = shape.corners.minOf { it.y }
    val width = shape.corners.maxOf { it.x } - left
    val height = shape.corners.maxOf { it.y } - bottom
    val places =
        (1 until GRID).flatMap { row -> (1 until GRID).map { Point(left + width * it / GRID, bottom + height * row / GRID) } } + centre
    val best =
        places.filter { shape.surrounds(it) }.maxByOrNull { shape.distanceToEdge(it) - LITTLE * distance(it, centre) }
            ?: return centre to 0.0
    return best to shape.distanceToEdge(best)
}

private fun Shape.Polygon.surrounds(place: Point): Boolean {
    var inside = false
    corners.forEachEdge { from, to ->
        val crosses = (from.y > place.y) != (to.y > place.y)
        if (crosses && place.x < (to.x - from.x) * (place.y - from.y) / (to.y - from.y) + from.x) inside = !inside
    }
    return inside
}

private fun Shape.Polygon.distanceToEdge(place: Point): Double {
    var nearest = Double.MAX_VALUE
    corners.forEachEdge { from, to ->
        val alongX = to.x - from.x
        val alongY = to.y - from.y
        val share = ((place.x - from.x) * alongX + (place.y - from.y) * alongY) / (alongX * alongX + alongY * alongY)
        val part = share.coerceIn(0.0, 1.0)
        nearest = minOf(nearest, distance(place, Point(from.x + part * alongX, from.y + part * alongY)))
    }
    return nearest
}

private fun distance(one: Point, other: Point) = hypot(other.x - one.x, other.y - one.y)

private const val GRID = 24
private const val LITTLE = 0.01
