package robotran.ui.sheet

import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.world.Ink
import robotran.world.InkStroke
import kotlin.math.max

/** The lines the pen has left, as wide as the pen is. */
internal fun DrawScope.drawInk(ink: Ink, transform: SheetTransform) {
    val width = max(PEN_WIDTH_CENTIMETRES * transform.pixelsPerCentimetre, LEAST_WIDTH_PIXELS)
    for (stroke in ink.strokes) drawStroke(stroke, width, transform)
}

private fun DrawScope.drawStroke(stroke: InkStroke, width: Float, transform: SheetTransform) {
    val points = stroke.points.map { transform.toPixels(it.x, it.y) }
    val first = points.firstOrNull() ?: return
    if (points.size == 1) {
        drawCircle(SheetColours.INK, width / 2, first)
        return
    }
    val path = Path().apply {
        moveTo(first.x, first.y)
        for (point in points.drop(1)) lineTo(point.x, point.y)
    }
    drawPath(path, SheetColours.INK, style = Stroke(width, cap = StrokeCap.Round, join = StrokeJoin.Round))
}

/** A broad felt-tip pen. */
private const val PEN_WIDTH_CENTIMETRES = 0.3f

/** In a picture so small that the line would vanish. */
private const val LEAST_WIDTH_PIXELS = 1f
