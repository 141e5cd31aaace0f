package robotran.worldediting

import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import kotlin.math.abs
import kotlin.math.floor

/**
 * What moving and turning keeps to.
 *
 * @property grid the centimetres between the lines that things are put on; 0 for none.
 * @property angle the degrees that things are turned by; 0 for whole degrees.
 * @property toOthers whether edges and middles of other things and of the paper draw things to them.
 */
data class Snapping(val grid: Double = 1.0, val angle: Double = 15.0, val toOthers: Boolean = true) {
    fun onGrid(place: Point) = Point(onGrid(place.x), onGrid(place.y))

    internal fun onGrid(coordinate: Double): Double = if (grid > 0) nearestMultiple(coordinate, grid) else coordinate

    internal fun onAngle(degrees: Double): Double = nearestMultiple(degrees, if (angle > 0) angle else 1.0)
}

/** A line that something was drawn to: at x if it [isUpright], else at y. */
data class Guide(val isUpright: Boolean, val at: Double)

/** Where things could be drawn to: coordinates across and up. */
internal class SnapLines(val across: List<Double>, val up: List<Double>)

/** A coordinate that was drawn to something, and to what; [guide] is null if it was to the grid. */
internal class Snapped(val coordinate: Double, val guide: Double?)

/** The edges and middles of all but [moving], and of the paper. */
internal fun World.snapLines(moving: Set<ElementRef>): SnapLines {
    val others = things().filter { it !in moving }.take(MAX_OTHERS).mapNotNull { piece(it)?.form?.bounds } +
        Bounds(0.0, 0.0, paper.width, paper.height)
    return SnapLines(
        others.flatMap { listOf(it.left, (it.left + it.right) / 2, it.right) },
        others.flatMap { listOf(it.bottom, (it.bottom + it.top) / 2, it.top) },
    )
}

/**
 * The same for a single point: also the points of other lines and polygons, so that walls meet, and those next to it.
 */
internal fun World.cornerLines(moving: Set<ElementRef>, neighbours: List<Point>): SnapLines {
    val others =
        things().filter { it !in moving }.take(MAX_OTHERS).mapNotNull { piece(it)?.form }.flatMap { it.corners } +
            neighbours
    val edges = listOf(Point(0.0, 0.0), Point(paper.width, paper.height))
    return SnapLines((others + edges).map { it.x }, (others + edges).map { it.y })
}

/**
 * How far something is really moved that somebody wants to move by [by].
 *
 * @param own the coordinates of it that may be drawn to [lines].
 * @param anchor the one that is put on the grid.
 */
internal fun Snapping.move(by: Double, own: List<Double>, anchor: Double, lines: List<Double>, reach: Double): Snapped {
    if (toOthers) {
        var best: Snapped? = null
        for (line in lines) {
            for (coordinate in own) {
                val wanted = line - coordinate
                val isNearer = best == null || abs(wanted - by) < abs(best.coordinate - by)
                if (isNearer && abs(wanted - by) <= reach) best = Snapped(wanted, line)
            }
        }
        best?.let { return it }
    }
    val isMoved = grid <= 0 || abs(by) >= grid / 2
    return Snapped(if (isMoved) onGrid(anchor + by) - anchor else 0.0, null)
}

/** [place] drawn to [lines] or to the grid. */
internal fun Snapping.point(place: Point, lines: SnapLines, reach: Double): Pair<Point, List<Guide>> {
    val x = coordinate(place.x, lines.across, reach)
    val y = coordinate(place.y, lines.up, reach)
    return Point(x.coordinate, y.coordinate) to guides(x, y)
}

internal fun guides(x: Snapped, y: Snapped): List<Guide> =
    listOfNotNull(x.guide?.let { Guide(isUpright = true, it) }, y.guide?.let { Guide(isUpright = false, it) })

private fun Snapping.coordinate(wanted: Double, lines: List<Double>, reach: Double): Snapped {
    val line = lines.takeIf { toOthers }?.minByOrNull { abs(it - wanted) }?.takeIf { abs(it - wanted) <= reach }
    return if (line != null) Snapped(line, line) else Snapped(onGrid(wanted), null)
}

private fun nearestMultiple(number: Double, step: Double): Double = floor(number / step + HALF) * step

private const val HALF = 0.5

/** More would take longer than a frame. */
private const val MAX_OTHERS = 300
