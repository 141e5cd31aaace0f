package robotran.worldediting

import robotran.world.World
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import kotlin.math.abs
import kotlin.math.floor

/**
 * The snap settings for moves and rotations.
 *
 * @property grid centimetres between grid lines; 0 for none.
 * @property angle the step of rotations in degrees; 0 for whole degrees.
 * @property toOthers whether to snap to edges and centres of other elements and of the paper.
 */
data class Snapping(val grid: Double = 1.0, val angle: Double = 15.0, val toOthers: Boolean = true) {
    fun onGrid(point: Point) = Point(onGrid(point.x), onGrid(point.y))

    internal fun onGrid(coordinate: Double): Double = if (grid > 0) nearestMultiple(coordinate, grid) else coordinate

    internal fun onAngle(degrees: Double): Double = nearestMultiple(degrees, if (angle > 0) angle else 1.0)
}

/** A line that an element has snapped to: at x if it [isUpright], otherwise at y. */
data class Guide(val isUpright: Boolean, val at: Double)

/** The x and y coordinates available for snapping. */
internal class SnapLines(val across: List<Double>, val up: List<Double>)

/** A snapped coordinate and its guide; [guide] is null if it snapped to the grid. */
internal class Snapped(val coordinate: Double, val guide: Double?)

/** The edges and centres of all elements but [moving], and of the paper. */
internal fun World.snapLines(moving: Set<ElementRef>): SnapLines {
    val others = things().filter { it !in moving }.take(MAX_OTHERS).mapNotNull { piece(it)?.form?.bounds } +
        Bounds(0.0, 0.0, paper.width, paper.height)
    return SnapLines(
        others.flatMap { listOf(it.left, (it.left + it.right) / 2, it.right) },
        others.flatMap { listOf(it.bottom, (it.bottom + it.top) / 2, it.top) },
    )
}

/** The same for a single point: also the points of other lines and polygons, so that walls meet, and [neighbours]. */
internal fun World.cornerLines(moving: Set<ElementRef>, neighbours: List<Point>): SnapLines {
    val others =
        things().filter { it !in moving }.take(MAX_OTHERS).mapNotNull { piece(it)?.form }.flatMap { it.corners } +
            neighbours
    val edges = listOf(Point(0.0, 0.0), Point(paper.width, paper.height))
    return SnapLines((others + edges).map { it.x }, (others + edges).map { it.y })
}

/**
 * The snapped distance for a move by [by].
 *
 * @param own the element's coordinates that may snap to [lines].
 * @param anchor the coordinate that snaps to the grid.
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

/** [point] snapped to [lines] or to the grid. */
internal fun Snapping.point(point: Point, lines: SnapLines, reach: Double): Pair<Point, List<Guide>> {
    val x = coordinate(point.x, lines.across, reach)
    val y = coordinate(point.y, lines.up, reach)
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
