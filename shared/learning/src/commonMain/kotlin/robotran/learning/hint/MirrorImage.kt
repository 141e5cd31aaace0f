package robotran.learning.hint

import robotran.world.geometry.Point
import kotlin.math.sqrt

internal fun lengthOf(points: List<Point>): Double = points.zipWithNext().sumOf { (a, b) -> distance(a, b) }

/** Whether the ink, reflected in the line that the robot looked along at first, covers most of the template. */
internal fun isMirrorImage(attempt: Attempt): Boolean {
    val template = attempt.world.template ?: return false
    val start = attempt.run.trail.firstOrNull { it.robot == 0 }?.points ?: return false
    val origin = start.firstOrNull() ?: return false
    val ahead = start.firstOrNull { distance(it, origin) > LITTLE } ?: return false
    val way = distance(origin, ahead)
    val axis = Point((ahead.x - origin.x) / way, (ahead.y - origin.y) / way)
    val mirrored = attempt.run.ink.strokes.map { stroke -> stroke.points.map { reflected(it, origin, axis) } }
    val wanted = template.strokes.flatMap(::dotted)

    fun share(strokes: List<List<Point>>) =
        wanted.count { dot -> strokes.any { isNear(dot, it) } }.toDouble() / wanted.size
    return share(mirrored) > MOST && share(attempt.run.ink.strokes.map { it.points }) < MOST
}

private fun reflected(point: Point, origin: Point, axis: Point): Point {
    val x = point.x - origin.x
    val y = point.y - origin.y
    val along = x * axis.x + y * axis.y
    return Point(origin.x + 2 * along * axis.x - x, origin.y + 2 * along * axis.y - y)
}

/** Points on [stroke], about a centimetre apart. */
private fun dotted(stroke: List<Point>): List<Point> = stroke.zipWithNext().flatMap { (a, b) ->
    val parts = maxOf(1, distance(a, b).toInt())
    List(parts) { Point(a.x + (b.x - a.x) * it / parts, a.y + (b.y - a.y) * it / parts) }
}

private fun isNear(dot: Point, stroke: List<Point>): Boolean = stroke.zipWithNext().any { (a, b) ->
    val x = b.x - a.x
    val y = b.y - a.y
    val square = x * x + y * y
    val along = if (square == 0.0) 0.0 else (((dot.x - a.x) * x + (dot.y - a.y) * y) / square).coerceIn(0.0, 1.0)
    distance(dot, Point(a.x + along * x, a.y + along * y)) < NEAR
}

internal fun distance(a: Point, b: Point): Double = sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y))

/** This share of the template is enough to see what was meant. */
private const val MOST = 0.85

/** In centimetres. */
private const val NEAR = 1.5
