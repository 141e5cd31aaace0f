package robotran.ui.sheet

import robotran.uikit.*
import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.geometry.centre

/**
 * A point in [shape] far from its edge, for a label, and its distance from the edge: the centre of a circle or
 * rectangle, and for a polygon, which may be concave, the best point of a grid.
 */
internal fun roomiestPoint(shape: Shape): Pair<Point, Double> = when (shape) {
    is Shape.Circle -> shape.centre to shape.radius
    is Shape.Rectangle -> shape.centre to minOf(shape.width, shape.height) / 2
    is Shape.Polygon -> roomiestPoint(shape)
}

/** Of equally good points, the one nearest to their mean. */
private fun roomiestPoint(shape: Shape.Polygon): Pair<Point, Double> {
    val centre = shape.centre
    val left = shape.corners.minOf { it.x }
    val bottom = shape.corners.minOf { it.y }
    val width = shape.corners.maxOf { it.x } - left
    val height = shape.corners.maxOf { it.y } - bottom
    val places =
        (1 until GRID).flatMap { row ->
            (1 until GRID).map {
                Point(
                    left + width * it / GRID,
                    bottom + height * row / GRID,
                )
            }
        } +
            centre
    val best =
        places.filter { surrounds(shape.corners, it) }.maxByOrNull {
            distanceToEdge(shape.corners, it) -
                LITTLE * distance(it, centre)
        }
            ?: return centre to 0.0
    return best to distanceToEdge(shape.corners, best)
}

private const val GRID = 24
private const val LITTLE = 0.01
