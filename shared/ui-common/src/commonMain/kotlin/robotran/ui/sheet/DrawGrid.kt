package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextMeasurer
import robotran.uikit.*
import robotran.world.Paper

/** A line across the paper every ten centimetres, and finer ones every one, two or five if there is room. */
internal fun DrawScope.drawGrid(transform: SheetTransform) {
    val step = FINE_STEPS.firstOrNull { it * transform.pixelsPerCentimetre >= MIN_STEP_PIXELS }
    if (step != null) drawLines(transform, step, FINE_ALPHA)
    drawLines(transform, STEP, ALPHA)
}

private fun DrawScope.drawLines(transform: SheetTransform, step: Int, alpha: Float) {
    val paper = transform.paper
    val colour = SheetColours.GRID.copy(alpha = alpha)
    val pixels = step * transform.pixelsPerCentimetre
    if (pixels <= 0f) return
    for (number in 1..(paper.width / pixels).toInt()) {
        val x = paper.left + number * pixels
        drawLine(colour, Offset(x, paper.top), Offset(x, paper.bottom))
    }
    for (number in 1..(paper.height / pixels).toInt()) {
        val y = paper.bottom - number * pixels
        drawLine(colour, Offset(paper.left, y), Offset(paper.right, y))
    }
}

/**
 * The distance of each line from the paper's corner in centimetres, along its lower and left edge, or along the pane's
 * if those are not visible.
 */
internal fun DrawScope.drawGridFigures(
    paper: Paper,
    view: SheetTransform,
    colours: SheetColours,
    labels: TextMeasurer,
) {
    val height = FIGURE_SIZE.toPx()
    // Only every second, fifth or tenth line if they are too close for numbers.
    val step = FIGURE_STEPS.firstOrNull { it * view.pixelsPerCentimetre >= height * FIGURE_ROOM } ?: return
    val low = (view.paper.bottom + view.pixelsPerCentimetre + height).coerceIn(
        height,
        (size.height - height).coerceAtLeast(height),
    )
    for (x in step..paper.width.toInt() step step) {
        val place = view.toPixels(x.toDouble(), 0.0).x
        if (place in 0f..size.width) drawLabel(labels, "$x", Offset(place, low), height, colours.parameters)
    }
    // Beside the wall around the paper or, if there is no room, on the paper.
    val beside = view.paper.left - view.pixelsPerCentimetre - height
    val left = if (beside >= height) {
        minOf(beside, size.width - height)
    } else {
        maxOf(view.paper.left, 0f) + height * ON_PAPER
    }
    for (y in step..paper.height.toInt() step step) {
        val place = view.toPixels(0.0, y.toDouble()).y
        if (place in 0f..size.height) drawLabel(labels, "$y", Offset(left, place), height, colours.parameters)
    }
}

private const val STEP = 10
private val FINE_STEPS = listOf(1, 2, 5)
private val FIGURE_STEPS = listOf(10, 20, 50, 100, 200, 500)
private const val MIN_STEP_PIXELS = 12f
private const val ALPHA = 0.45f
private const val FINE_ALPHA = 0.16f
private val FIGURE_SIZE = TextSizes.SIGN
private const val FIGURE_ROOM = 2.6f

/** The distance of the numbers' centres on the paper from its edge, relative to their height. */
private const val ON_PAPER = 1.4f
