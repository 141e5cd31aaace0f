package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.world.geometry.Point

/**
 * The paths of a line that grows at its end, in pieces. Only the last piece is rebuilt, so the cost of a frame does not
 * depend on the length of the line.
 */
class LinePaths(private val transform: SheetTransform) {
    private val finished = mutableListOf<LinePiece>()
    private var drawn: List<Point> = emptyList()

    var pieces: List<LinePiece> = emptyList()
        private set

    /** The position of a dot if the pen did not move; null for a line. */
    var dot: Offset? = null
        private set

    /** Where the line begins, and where it ends by now. */
    var ends: List<Offset> = emptyList()
        private set

    /** Whether [points] equal, or extend, what was drawn last. */
    fun continues(points: List<Point>): Boolean {
        val last = finished.size * LinePiece.POINTS
        return drawn.isNotEmpty() && points.size > last && points.first() === drawn.first() &&
            points[last] === drawn[last]
    }

    /**
     * Prepares a line through [points] for drawing. If the line continues, all but its last old point must be
     * unchanged.
     */
    fun show(points: List<Point>) {
        if (!continues(points)) finished.clear()
        drawn = points
        ends = listOf(points.first(), points.last()).map(transform::toPixels)
        dot = points.singleOrNull()?.let(transform::toPixels)
        // The last point may still move, so a piece is finished only when the next one has started.
        while ((finished.size + 1) * LinePiece.POINTS < points.size - 1) {
            finished += piece(points, finished.size, points.size)
        }
        pieces = finished + piece(points, finished.size, points.size)
    }

    private fun piece(points: List<Point>, number: Int, size: Int): LinePiece {
        val from = number * LinePiece.POINTS
        return LinePiece((from..minOf(from + LinePiece.POINTS, size - 1)).map { transform.toPixels(points[it]) })
    }
}

/** A part of a line, in pixels. */
class LinePiece(points: List<Offset>) {
    val outline = Outline(Outline.Polyline(points))
    private val bounds =
        Rect(points.minOf { it.x }, points.minOf { it.y }, points.maxOf { it.x }, points.maxOf { it.y })

    /** Whether any of it is visible in [area] with a line width of [width]. */
    fun isIn(area: Rect, width: Float): Boolean = bounds.inflate(width).overlaps(area)

    companion object {
        /** The number of points of a full piece. */
        const val POINTS = 200
    }
}
