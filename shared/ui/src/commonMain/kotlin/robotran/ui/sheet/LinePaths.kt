package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import robotran.world.geometry.Point

/**
 * The paths of a line that grows at its end, in pieces: only the last one is made anew when it does, so that hours of
 * drawing cost no more in a frame than a second of it.
 */
internal class LinePaths(private val transform: SheetTransform) {
    private val finished = mutableListOf<LinePiece>()
    private var drawn: List<Point> = emptyList()

    var pieces: List<LinePiece> = emptyList()
        private set

    /** Where a pen was only put down; null where it drew a line. */
    var dot: Offset? = null
        private set

    /** Whether [points] are what was drawn last, or that with more behind it. */
    fun continues(points: List<Point>): Boolean {
        val last = finished.size * LinePiece.POINTS
        return drawn.isNotEmpty() && points.size > last && points.first() === drawn.first() &&
            points[last] === drawn[last]
    }

    /**
     * Makes ready for drawing a line through [points]; of a line that goes on, all but its last point must be as
     * before.
     */
    fun show(points: List<Point>) {
        if (!continues(points)) finished.clear()
        drawn = points
        dot = points.singleOrNull()?.let(transform::toPixels)
        // The last point may still move, so a piece is finished only when another has begun.
        while ((finished.size + 1) * LinePiece.POINTS <
            points.size - 1
        ) {
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
internal class LinePiece(points: List<Offset>) {
    val path = Path().apply { addLine(points) }
    private val bounds =
        Rect(points.minOf { it.x }, points.minOf { it.y }, points.maxOf { it.x }, points.maxOf { it.y })

    /** Whether any of it can be seen in [area] if it is [width] wide. */
    fun isIn(area: Rect, width: Float): Boolean = bounds.inflate(width).overlaps(area)

    companion object {
        /** How many points a piece has before the next begins. */
        const val POINTS = 200
    }
}
