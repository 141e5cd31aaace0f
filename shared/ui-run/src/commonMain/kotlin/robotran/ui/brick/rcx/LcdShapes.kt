package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import robotran.rcxrom.display.LcdIcon
import robotran.ui.brick.front.polygon

private val QUARTERS =
    listOf(
        LcdIcon.DATALOG_TOP_RIGHT,
        LcdIcon.DATALOG_BOTTOM_RIGHT,
        LcdIcon.DATALOG_BOTTOM_LEFT,
        LcdIcon.DATALOG_TOP_LEFT,
    )
private val QUARTER_GAPS = listOf(Offset(1f, -1f), Offset(1f, 1f), Offset(-1f, 1f), Offset(-1f, -1f))

private val DOTS = listOf(LcdIcon.DOT_1, LcdIcon.DOT_2, LcdIcon.DOT_3, LcdIcon.DOT_4, LcdIcon.DOT_5)

private val POINTS = listOf(LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)

private val SENSORS = listOf(
    LcdIcon.SENSOR_1_VIEW to LcdIcon.SENSOR_1_ACTIVE,
    LcdIcon.SENSOR_2_VIEW to LcdIcon.SENSOR_2_ACTIVE,
    LcdIcon.SENSOR_3_VIEW to LcdIcon.SENSOR_3_ACTIVE,
)

private val MOTORS = listOf(
    Triple(LcdIcon.MOTOR_A_VIEW, LcdIcon.MOTOR_A_BACKWARD, LcdIcon.MOTOR_A_FORWARD),
    Triple(LcdIcon.MOTOR_B_VIEW, LcdIcon.MOTOR_B_BACKWARD, LcdIcon.MOTOR_B_FORWARD),
    Triple(LcdIcon.MOTOR_C_VIEW, LcdIcon.MOTOR_C_BACKWARD, LcdIcon.MOTOR_C_FORWARD),
)

/** The outlines of all segments that are not part of a digit, on the [LcdPlan]; the men are in [LcdMen]. */
internal val lcdIconShapes: Map<LcdIcon, Path> = buildMap {
    LcdPlan.PORT_COLUMNS.forEachIndexed { column, x ->
        put(SENSORS[column].first, chevron(x, tip = LcdPlan.SENSOR_ROW.start, base = LcdPlan.SENSOR_ROW.endInclusive))
        put(
            SENSORS[column].second,
            wedge(x, tip = LcdPlan.SENSOR_ROW.start + 12f, base = LcdPlan.SENSOR_ROW.endInclusive),
        )
        val (shown, backward, forward) = MOTORS[column]
        put(shown, chevron(x, tip = LcdPlan.MOTOR_ROW.endInclusive, base = LcdPlan.MOTOR_ROW.start))
        put(backward, sideArrow(x - 31f, x - 20f))
        put(forward, sideArrow(x + 31f, x + 20f))
    }
    QUARTERS.forEachIndexed { quarter, icon -> put(icon, quarterOfCircle(quarter)) }
    DOTS.zip(LcdPlan.DOTS).forEach { (icon, place) -> put(icon, Path().apply { addRect(place) }) }
    put(LcdIcon.LOW_BATTERY, battery(LcdPlan.BATTERY))
    put(LcdIcon.INFRARED_SHORT, nearBeam(LcdPlan.INFRARED))
    put(LcdIcon.INFRARED_LONG, farBeam(LcdPlan.INFRARED))
    put(LcdIcon.MINUS, Path().apply { addRect(LcdPlan.MINUS) })
    POINTS.zip(LcdPlan.POINTS).forEach { (icon, middle) ->
        put(icon, Path().apply { addOval(Rect(middle, LcdPlan.POINT_RADIUS)) })
    }
}

/** A hollow arrowhead that points at a port above or below. */
private fun chevron(x: Float, tip: Float, base: Float): Path {
    val inner = tip + (base - tip) * 0.36f
    return polygon(x - 15f, base, x, tip, x + 15f, base, x + 10f, base, x, inner, x - 10f, base)
}

/** A solid arrowhead inside a [chevron]. */
private fun wedge(x: Float, tip: Float, base: Float): Path = polygon(x - 6.5f, base, x, tip, x + 6.5f, base)

private fun sideArrow(tip: Float, base: Float): Path {
    val middle = (LcdPlan.MOTOR_ROW.start + LcdPlan.MOTOR_ROW.endInclusive) / 2 + 2f
    return polygon(tip, middle, base, middle - 8f, base, middle + 8f)
}

/** Clockwise from the top, with a gap to its neighbours. */
private fun quarterOfCircle(quarter: Int): Path = Path().apply {
    val middle = LcdPlan.DATALOG.center
    moveTo(middle.x, middle.y)
    arcTo(LcdPlan.DATALOG, quarter * 90f - 90f, 90f, forceMoveTo = false)
    close()
    translate(QUARTER_GAPS[quarter])
}

/** A crossed-out battery with its pole on the right. */
private fun battery(bounds: Rect): Path = Path().apply {
    addPath(bar(bounds.copy(bottom = bounds.top + BATTERY_LINE)))
    addPath(bar(bounds.copy(top = bounds.bottom - BATTERY_LINE)))
    addPath(bar(bounds.copy(right = bounds.left + BATTERY_LINE)))
    addPath(bar(bounds.copy(left = bounds.right - BATTERY_LINE)))
    addPath(bar(Rect(bounds.right, bounds.center.y - 3.5f, bounds.right + 4f, bounds.center.y + 3.5f)))
    val x = bounds.center.x
    val (top, bottom) = bounds.top - 2f to bounds.bottom + 2f
    addPath(polygon(x - 11f, top, x - 7.5f, top, x + 11f, bottom, x + 7.5f, bottom))
    addPath(polygon(x + 7.5f, top, x + 11f, top, x - 7.5f, bottom, x - 11f, bottom))
}

/** Clockwise like the polygons: overlapping shapes of opposite direction in one path would leave a hole. */
private fun bar(bounds: Rect): Path = with(bounds) { polygon(left, top, right, top, right, bottom, left, bottom) }

/** The lower part of the beam, shared by both ranges. */
private fun nearBeam(bounds: Rect): Path {
    val x = bounds.center.x
    return polygon(x, bounds.bottom, x - 6f, bounds.center.y + 2f, x + 6f, bounds.center.y + 2f)
}

private fun farBeam(bounds: Rect): Path {
    val x = bounds.center.x
    val y = bounds.center.y - 3f
    return polygon(x - 6.8f, y, bounds.left, bounds.top, bounds.right, bounds.top, x + 6.8f, y)
}

/** The line width of the battery. */
private const val BATTERY_LINE = 2.4f
