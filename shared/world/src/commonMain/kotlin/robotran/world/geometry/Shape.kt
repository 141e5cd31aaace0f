package robotran.world.geometry

/** A shape on the paper, in centimetres and degrees counter-clockwise. */
sealed interface Shape {
    /**
     * A rectangle around its [centre], rotated by [angle]; without rotation, [width] is along x and [height] along y.
     */
    data class Rectangle(val centre: Point, val width: Double, val height: Double, val angle: Double = 0.0) : Shape

    data class Circle(val centre: Point, val radius: Double) : Shape

    /** @property corners three or more, in either direction; the edges do not cross. It may be concave. */
    data class Polygon(val corners: List<Point>) : Shape
}
