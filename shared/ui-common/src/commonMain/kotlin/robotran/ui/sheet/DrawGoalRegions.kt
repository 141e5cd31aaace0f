package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.simulation.state.GoalProgress
import robotran.uikit.*
import robotran.world.RegionRole
import robotran.world.geometry.Shape
import kotlin.math.max

class RegionDrawing(val region: GoalRegion, transform: SheetTransform) {
    private val polygon = (region.shape as? Shape.Polygon)?.let(SeamlessPolygon::of)
    val area = Outline.of(polygon?.let { Shape.Polygon(it.corners) } ?: region.shape, transform)

    /** Its visible edge. */
    val edge: Outline = polygon?.outline?.let { pieces ->
        Outline(pieces.map { Outline.Polyline(it.map(transform::toPixels)) })
    } ?: area

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
internal fun DrawTarget.drawRegion(
    drawing: RegionDrawing,
    goals: List<GoalProgress>,
    transform: SheetTransform,
    withFlag: Boolean = true,
) {
    val width = max(LINE_CENTIMETRES * transform.pixelsPerCentimetre, MIN_LINE_PIXELS * transform.least)
    when (drawing.region.role) {
        RegionRole.TARGET -> {
            val met = drawing.region.isMet(goals)
            shape(drawing.area, SheetColours.REACH.copy(alpha = if (met) MET_ALPHA else FILL_ALPHA))
            shape(drawing.edge, edge = SheetColours.REACH.copy(alpha = LINE_ALPHA), line = Line(width))
            if (withFlag) drawFlag(drawing, transform)
        }

        RegionRole.FORBIDDEN -> {
            shape(drawing.area, SheetColours.STAY_OUT.copy(alpha = FILL_ALPHA))
            shape(drawing.edge, edge = SheetColours.STAY_OUT, line = dashed(width, SHORT_DASH))
        }

        RegionRole.PERMITTED -> shape(drawing.edge, edge = SheetColours.STAY_IN, line = dashed(width, LONG_DASH))
    }
}

private fun dashed(width: Float, dash: Float) = Line(width, dashes = dash * width to SHORT_DASH * width)

/** A chequered flag in the middle of the region, with its number if there is an order. */
private fun DrawTarget.drawFlag(drawing: RegionDrawing, transform: SheetTransform) {
    val bounds = drawing.flag
    val size = minOf(bounds.minDimension * FLAG_PART, MAX_FLAG_CENTIMETRES * transform.pixelsPerCentimetre)
    val number = drawing.region.number?.takeIf { hasText }
    val middle = if (number != null) bounds.center - Offset(size * 0.25f, 0f) else bounds.center
    val top = middle - Offset(size * 0.4f, size / 2)
    val cell = Size(size * 0.2f, size * 0.2f)
    line(top, top + Offset(0f, size), SheetColours.FLAG, max(size / 14, transform.least), isRound = true)
    box(Rect(top, Size(cell.width * FLAG_COLUMNS, cell.height * FLAG_ROWS)), RobotranColours.CASING)
    for (row in 0 until FLAG_ROWS) {
        for (column in row % 2 until FLAG_COLUMNS step 2) {
            box(Rect(top + Offset(column * cell.width, row * cell.height), cell), SheetColours.FLAG)
        }
    }
    if (number != null) {
        text(number.toString(), bounds.center + Offset(size * 0.55f, 0f), size * 0.8f, SheetColours.FLAG)
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
