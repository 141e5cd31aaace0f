package robotran.ui.sheet

import robotran.world.geometry.Point
import robotran.world.geometry.Shape
import robotran.world.geometry.centre

/**
 * A place in [shape] that is far from its edge, where something can be written, and how far that is: the centre of a
 * circle or rectangle, and of a polygon, which may be dented, the best of a grid of places.
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
