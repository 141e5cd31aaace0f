package robotran.narration

import robotran.simulation.state.Ink
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.distance
import robotran.world.geometry.flat
import kotlin.math.floor

/** Reads what is printed and drawn on the paper of [world], prepared to be asked many times a second. */
class SheetReader(world: World) {
    private val marks = world.marks.map(::SeenMark).reversed()

    /** How much light the mark that is seen at [point] gives back, from 0 to 1; null where the paper is bare. */
    fun reflectanceAt(point: Point): Double? = seenAt(point)?.reflectanceAt(point)

    fun hasInk(ink: Ink, point: Point): Boolean = ink.strokes.any { isOn(it.points, point, INK_REACH) }

    /** The mark that is seen at [point]; null if there is none. */
    internal fun markAt(point: Point): Mark? = seenAt(point)?.mark

    private fun seenAt(point: Point): SeenMark? = marks.firstOrNull { it.reflectanceAt(point) != null }

    private companion object {
        /** Half the width of the pen's line, and a little more for the spot of a light sensor, in centimetres. */
        const val INK_REACH = 0.3
    }
}

private class SeenMark(val mark: Mark) {
    private val figure = mark.figure
    private val outline: Outline? = (figure as? MarkFigure.Area)?.let { flat(it.shape) }
    private val reflectance = mark.shade.reflectance
    private val way = (figure as? MarkFigure.Line)?.way.orEmpty()

    /** Null where it does not cover the paper. */
    fun reflectanceAt(point: Point): Double? = when (figure) {
        is MarkFigure.Area -> reflectance.takeIf { checkNotNull(outline).contains(point.x, point.y) }
        is MarkFigure.Line -> reflectance.takeIf { isOn(way, point, figure.width / 2) }
        is MarkFigure.GreyMap -> figure.reflectanceAt(point)
    }

    private fun MarkFigure.GreyMap.reflectanceAt(point: Point): Double? {
        val column = floor((point.x - corner.x) / cell).toInt()
        val row = rows.size - 1 - floor((point.y - corner.y) / cell).toInt()
        return rows.getOrNull(row)?.getOrNull(column)?.digitToIntOrNull(HEXADECIMAL)?.let { it / WHITEST }
    }

    private companion object {
        const val HEXADECIMAL = 16
        const val WHITEST = 15.0
    }
}

/** The points of a line, with the first one again at the end of a closed one. */
internal val MarkFigure.Line.way: List<Point> get() = if (closed) points + points.first() else points

/** Whether [point] is within [reach] of the line through [points]. Looks closer only where it may be near. */
internal fun isOn(points: List<Point>, point: Point, reach: Double): Boolean {
    if (points.size == 1) return distance(point, points[0], points[0]) <= reach
    for (number in 1..<points.size) {
        val from = points[number - 1]
        val to = points[number]
        val isAside = point.x < minOf(from.x, to.x) - reach || point.x > maxOf(from.x, to.x) + reach ||
            point.y < minOf(from.y, to.y) - reach || point.y > maxOf(from.y, to.y) + reach
        if (!isAside && distance(point, from, to) <= reach) return true
    }
    return false
}
