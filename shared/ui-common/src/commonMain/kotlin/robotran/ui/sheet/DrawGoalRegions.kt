package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import robotran.simulation.state.GoalProgress
import robotran.uikit.*
import robotran.world.RegionRole
import robotran.world.geometry.Shape
import kotlin.math.max

class RegionDrawing(val region: GoalRegion, transform: SheetTransform) {
    private val polygon = (region.shape as? Shape.Polygon)?.let(SeamlessPolygon::of)
    val path = pathOf(polygon?.let { Shape.Polygon(it.corners) } ?: region.shape, transform)

    /** Its visible edge. */
    val outline: Path = polygon?.outline?.let { pieces ->
        Path().apply { for (piece in pieces) addLine(piece.map(transform::toPixels)) }
    } ?: path

    /** The position of its flag and the space around it. */
    val flag: Rect = roomiestPoint(region.shape).let { (place, room) ->
        Rect(transform.toPixels(place.x, place.y), (room * transform.pixelsPerCentimetre).toFloat())
    }
}

/**
 * To reach: green with a flag, stronger once reached. To avoid: red dashes. Not to leave: long blue-grey dashes.
 *
 * @param withFlag whether the flag is drawn on the paper, too.
 */
internal fun DrawScope.drawRegion(
    drawing: RegionDrawing,
    goals: List<GoalProgress>,
    transform: SheetTransform,
    labels: TextMeasurer?,
    withFlag: Boolean = true,
) {
    val width = max(LINE_CENTIMETRES * transform.pixelsPerCentimetre, MIN_LINE_PIXELS)
    when (drawing.region.role) {
        RegionRole.TARGET -> {
            val met = drawing.region.isMet(goals)
            drawPath(drawing.path, SheetColours.REACH.copy(alpha = if (met) MET_ALPHA else FILL_ALPHA))
            drawPath(drawing.outline, SheetColours.REACH.copy(alpha = LINE_ALPHA), style = Stroke(width))
            if (withFlag) drawFlag(drawing, transform, labels)
        }

        RegionRole.FORBIDDEN -> {
            drawPath(drawing.path, SheetColours.STAY_OUT.copy(alpha = FILL_ALPHA))
            drawDashes(drawing.outline, SheetColours.STAY_OUT, width, SHORT_DASH)
        }

        RegionRole.PERMITTED -> drawDashes(drawing.outline, SheetColours.STAY_IN, width, LONG_DASH)
    }
}

private fun DrawScope.drawDashes(path: Path, colour: Color, width: Float, dash: Float) {
    val dashes = PathEffect.dashPathEffect(floatArrayOf(dash * width, SHORT_DASH * width))
    drawPath(path, colour, style = Stroke(width, pathEffect = dashes))
}

/** A chequered flag in the middle of the region, with its number if there is an order. */
private fun DrawScope.drawFlag(drawing: RegionDrawing, transform: SheetTransform, labels: TextMeasurer?) {
    val bounds = drawing.flag
    val size = minOf(bounds.minDimension * FLAG_PART, MAX_FLAG_CENTIMETRES * transform.pixelsPerCentimetre)
    val number = drawing.region.number
    val middle = if (number != null && labels != null) bounds.center - Offset(size * 0.25f, 0f) else bounds.center
    val top = middle - Offset(size * 0.4f, size / 2)
    val cell = Size(size * 0.2f, size * 0.2f)
    drawLine(SheetColours.FLAG, top, top + Offset(0f, size), max(size / 14, 1f), StrokeCap.Round)
    drawRect(RobotranColours.CASING, top, Size(cell.width * FLAG_COLUMNS, cell.height * FLAG_ROWS))
    for (row in 0 until FLAG_ROWS) {
        for (column in 0 until FLAG_COLUMNS) {
            if ((row + column) % 2 == 0) {
                drawRect(SheetColours.FLAG, top + Offset(column * cell.width, row * cell.height), cell)
            }
        }
    }
    if (number != null && labels != null) {
        drawLabel(labels, number.toString(), bounds.center + Offset(size * 0.55f, 0f), size * 0.8f, SheetColours.FLAG)
    }
}

private const val LINE_CENTIMETRES = 0.3f
private const val MIN_LINE_PIXELS = 1.5f
private const val FILL_ALPHA = 0.1f
private const val MET_ALPHA = 0.35f
private const val LINE_ALPHA = 0.7f

/** Relative to the line's width. */
private const val SHORT_DASH = 3f
private const val LONG_DASH = 8f

private const val FLAG_PART = 0.45f
private const val MAX_FLAG_CENTIMETRES = 6f
private const val FLAG_COLUMNS = 4
private const val FLAG_ROWS = 3
