package robotran.simulation.light

import robotran.world.MarkFigure
import robotran.world.Shade
import robotran.world.geometry.Bounds
import robotran.world.geometry.Outline
import kotlin.math.floor

/** The part of one mark within one square of the paper. */
internal sealed interface MarkLayer {
    /** The mark's reflectance at a point of the square, or a negative number where it does not cover the paper. */
    fun reflectanceAt(x: Double, y: Double): Double

    /** The mark's colour at a point of the square; null where it does not cover the paper. */
    fun tintAt(x: Double, y: Double): Tint?

    /** The mark covers the whole square. */
    class Everywhere(private val reflectance: Double, private val tint: Tint) : MarkLayer {
        override fun reflectanceAt(x: Double, y: Double) = reflectance

        override fun tintAt(x: Double, y: Double) = tint
    }

    class Within(private val outline: Outline, private val reflectance: Double, private val tint: Tint) : MarkLayer {
        override fun reflectanceAt(x: Double, y: Double) = if (outline.contains(x, y)) reflectance else BARE

        override fun tintAt(x: Double, y: Double) = tint.takeIf { outline.contains(x, y) }
    }

    /** @property pieces the line segments that reach into the square. */
    class Along(private val pieces: List<Capsule>, private val reflectance: Double, private val tint: Tint) :
        MarkLayer {
        override fun reflectanceAt(x: Double, y: Double): Double {
            for (number in pieces.indices) if (pieces[number].contains(x, y)) return reflectance
            return BARE
        }

        override fun tintAt(x: Double, y: Double) = tint.takeIf { pieces.any { it.contains(x, y) } }
    }

    class Picture(private val map: MarkFigure.GreyMap) : MarkLayer {
        override fun reflectanceAt(x: Double, y: Double): Double {
            val column = floor((x - map.corner.x) / map.cell).toInt()
            val row = map.rows.size - 1 - floor((y - map.corner.y) / map.cell).toInt()
            val digit = map.rows.getOrNull(row)?.getOrNull(column)?.digitToIntOrNull(HEXADECIMAL) ?: return BARE
            return digit / WHITEST
        }

        override fun tintAt(x: Double, y: Double) = reflectanceAt(x, y).takeIf { it >= 0 }?.let(Tint::grey)
    }

    companion object {
        /** Stands for no mark. */
        const val BARE = -1.0
        private const val HEXADECIMAL = 16
        private const val WHITEST = 15.0
    }
}

/** A figure prepared for clipping to the squares of the paper. */
internal class PreparedMark(private val figure: MarkFigure, private val outline: Outline?, shade: Shade) {
    private val reflectance = shade.reflectance
    private val tint = Tint.of(shade)
    private val pieces = (figure as? MarkFigure.Line)?.let { line ->
        val pairs = line.points.zipWithNext()
        if (line.closed) pairs + (line.points.last() to line.points.first()) else pairs
    }.orEmpty()

    private val squaredHalfWidth = (figure as? MarkFigure.Line)?.let { squareLimit(it.width / 2) } ?: 0.0

    /** The part of this mark in [square]; null if there is none. */
    fun layerIn(square: Bounds): MarkLayer? = when (figure) {
        is MarkFigure.Area -> areaIn(checkNotNull(outline), square)
        is MarkFigure.Line -> lineIn(figure, square)
        is MarkFigure.GreyMap -> MarkLayer.Picture(figure).takeIf { overlap(boundsOf(figure), square) }
    }

    private fun areaIn(outline: Outline, square: Bounds): MarkLayer? {
        if (!overlap(outline.bounds, square)) return null
        val x = (square.left + square.right) / 2
        val y = (square.bottom + square.top) / 2
        // A square that no edge crosses is completely inside or outside.
        if (outline.distanceToEdge(x, y) <= square.right - square.left) {
            return MarkLayer.Within(outline, reflectance, tint)
        }
        return if (outline.contains(x, y)) MarkLayer.Everywhere(reflectance, tint) else null
    }

    private fun lineIn(line: MarkFigure.Line, square: Bounds): MarkLayer? {
        val near = square.grownBy(line.width / 2)
        val crossing = pieces.filter { (from, to) ->
            overlap(near, Bounds(minOf(from.x, to.x), minOf(from.y, to.y), maxOf(from.x, to.x), maxOf(from.y, to.y)))
        }
        if (crossing.isEmpty()) return null
        return MarkLayer.Along(crossing.map { (from, to) -> Capsule(from, to, squaredHalfWidth) }, reflectance, tint)
    }

    private fun boundsOf(map: MarkFigure.GreyMap): Bounds {
        val columns = map.rows.maxOfOrNull { it.length } ?: 0
        return Bounds(
            map.corner.x,
            map.corner.y,
            map.corner.x + columns * map.cell,
            map.corner.y + map.rows.size * map.cell,
        )
    }

    private fun overlap(one: Bounds, other: Bounds) =
        one.left <= other.right && other.left <= one.right && one.bottom <= other.top && other.bottom <= one.top
}
