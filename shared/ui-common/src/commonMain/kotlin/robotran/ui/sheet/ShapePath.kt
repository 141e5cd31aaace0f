package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import robotran.world.Wall
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin

/** Adds a polyline through [points]. */
fun Path.addLine(points: List<Offset>, closed: Boolean = false) {
    val first = points.firstOrNull() ?: return
    moveTo(first.x, first.y)
    for (number in 1 until points.size) lineTo(points[number].x, points[number].y)
    if (closed) close()
}

/** The corners counter-clockwise, in centimetres; a circle has enough corners to look round. */
fun Shape.corners(): List<Point> = when (this) {
    is Shape.Circle -> (0 until CIRCLE_CORNERS).map { centre.towards(it * 2 * PI / CIRCLE_CORNERS, radius) }
    is Shape.Rectangle -> rectangle(centre, angle * RADIANS_PER_DEGREE, width / 2, height / 2)
    is Shape.Polygon -> if (twiceTheArea(corners) < 0) corners.reversed() else corners
}

/** The corners of a block after it was moved and turned about its centre. */
internal fun Shape.movedCorners(moved: Pose): List<Point> {
    val middle = centre
    val cosine = cos(moved.heading * RADIANS_PER_DEGREE)
    val sine = sin(moved.heading * RADIANS_PER_DEGREE)
    return corners().map {
        val x = it.x - middle.x
        val y = it.y - middle.y
        Point(middle.x + moved.x + x * cosine - y * sine, middle.y + moved.y + x * sine + y * cosine)
    }
}

/** The four corners of a wall, whose ends extend half its thickness beyond its line. */
fun Wall.corners(): List<Point> {
    val length = hypot(to.x - from.x, to.y - from.y)
    val middle = Point((from.x + to.x) / 2, (from.y + to.y) / 2)
    return rectangle(middle, kotlin.math.atan2(to.y - from.y, to.x - from.x), (length + thickness) / 2, thickness / 2)
}

/** The point at [distance] in the direction [angle], in radians. */
fun Point.towards(angle: Double, distance: Double) = Point(x + distance * cos(angle), y + distance * sin(angle))

private fun rectangle(centre: Point, angle: Double, halfLength: Double, halfWidth: Double): List<Point> {
    val cosine = cos(angle)
    val sine = sin(angle)

    fun corner(along: Double, across: Double) =
        Point(centre.x + along * cosine - across * sine, centre.y + along * sine + across * cosine)
    return listOf(
        corner(-halfLength, -halfWidth),
        corner(halfLength, -halfWidth),
        corner(halfLength, halfWidth),
        corner(-halfLength, halfWidth),
    )
}

private fun twiceTheArea(corners: List<Point>): Double {
    var area = 0.0
    corners.forEachEdge { from, to -> area += from.x * to.y - to.x * from.y }
    return area
}

/** From each corner to the next and from the last to the first. */
internal inline fun List<Point>.forEachEdge(action: (Point, Point) -> Unit) {
    for (number in indices) action(this[number], this[(number + 1) % size])
}

internal const val RADIANS_PER_DEGREE = PI / 180
private const val CIRCLE_CORNERS = 48
