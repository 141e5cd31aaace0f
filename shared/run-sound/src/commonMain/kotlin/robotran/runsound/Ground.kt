package robotran.runsound

import robotran.simulation.state.Ink
import robotran.world.Light
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.World
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.distance
import robotran.world.geometry.flat
import kotlin.math.floor

/** What is on the paper below a point of the robot. */
internal enum class Ground(val timbre: Timbre) {
    PAPER(Timbre.SINE),

    /** A line or another mark that is darker than paper. */
    MARK(Timbre.SAWTOOTH),
    INK(Timbre.SQUARE),
}

/** Finds what is on the paper of [world]. */
internal class GroundFinder(world: World) {
    private val marks = world.marks.map(::SeenMark).reversed()

    fun at(point: Point, ink: Ink): Ground = when {
        ink.isAt(point) -> Ground.INK
        marks.firstNotNullOfOrNull { it.isDarkAt(point) } == true -> Ground.MARK
        else -> Ground.PAPER
    }

    private fun Ink.isAt(point: Point): Boolean = strokes.any { isOn(it.points, point, SoundValues.INK_REACH) }
}

/** A mark, prepared to be asked often. */
private class SeenMark(mark: Mark) {
    private val figure = mark.figure
    private val outline: Outline? = (figure as? MarkFigure.Area)?.let { flat(it.shape) }
    private val isDark = isDark(mark.shade.reflectance)
    private val way = (figure as? MarkFigure.Line)?.let { if (it.closed) it.points + it.points.first() else it.points }

    /** Null where it does not cover the paper. */
    fun isDarkAt(point: Point): Boolean? = when (figure) {
        is MarkFigure.Area -> isDark.takeIf { checkNotNull(outline).contains(point.x, point.y) }
        is MarkFigure.Line -> isDark.takeIf { isOn(way.orEmpty(), point, figure.width / 2) }
        is MarkFigure.GreyMap -> figure.reflectanceAt(point)?.let(::isDark)
    }

    private fun MarkFigure.GreyMap.reflectanceAt(point: Point): Double? {
        val column = floor((point.x - corner.x) / cell).toInt()
        val row = rows.size - 1 - floor((point.y - corner.y) / cell).toInt()
        return rows.getOrNull(row)?.getOrNull(column)?.digitToIntOrNull(HEXADECIMAL)?.let { it / WHITEST }
    }

    private fun isDark(reflectance: Double) = reflectance < Light.PAPER - SoundValues.DARKER

    private companion object {
        const val HEXADECIMAL = 16
        const val WHITEST = 15.0
    }
}

/** Whether [point] is within [reach] of the line through [points]. Looks closer only where it may be near. */
private fun isOn(points: List<Point>, point: Point, reach: Double): Boolean {
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
