package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.simulation.state.Ink
import robotran.uikit.*
import robotran.world.Paper
import robotran.world.geometry.Point

/** A frame around what a pupil's robot drew, as around a picture on a wall; nothing without ink. */
fun DrawScope.drawDrawingFrame(ink: Ink, paper: Paper, transform: SheetTransform) {
    val (lower, upper) = drawingArea(ink, paper) ?: return
    val room = Rect(transform.toPixels(lower.x, upper.y), transform.toPixels(upper.x, lower.y))
    for ((colour, width) in listOf(RobotranColours.CASING to CASING.toPx(), RobotranColours.RUN_GREEN to LINE.toPx())) {
        drawRoundRect(
            colour,
            room.topLeft,
            Size(room.width, room.height),
            CornerRadius(Corners.SMALL.toPx()),
            style = Stroke(width),
        )
    }
}

/** The lower left and upper right corners of the area that [ink] takes of [paper], with a margin; null if it takes none. */
internal fun drawingArea(ink: Ink, paper: Paper): Pair<Point, Point>? {
    val points = ink.strokes.flatMap { it.points }
    if (points.isEmpty() || ink.lengthCentimetres < LEAST) return null
    val margin = maxOf(MARGIN, maxOf(paper.width, paper.height) * MARGIN_SHARE)
    return Point(
        (points.minOf { it.x } - margin).coerceIn(0.0, paper.width),
        (points.minOf { it.y } - margin).coerceIn(0.0, paper.height),
    ) to Point(
        (points.maxOf { it.x } + margin).coerceIn(0.0, paper.width),
        (points.maxOf { it.y } + margin).coerceIn(0.0, paper.height),
    )
}

/** In centimetres: less ink is a dot, no drawing. */
private const val LEAST = 3.0
private const val MARGIN = 3.0
private const val MARGIN_SHARE = 0.04
private val LINE = 3.dp
private val CASING = 6.dp
