package robotran.ui.brick

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.rom.LcdGlass
import robotran.rom.LcdIcon

/** The man before the program digit: the body is shared, the limbs say whether he stands or walks. */
internal fun DrawScope.drawMan(standing: Boolean, walking: Boolean) {
    val middle = LcdPlan.MAN.center.x
    val top = LcdPlan.MAN.top
    val body = tone(standing || walking)
    drawCircle(body, 3f, Offset(middle, top + 3.5f))
    line(body, middle, top + 8f, middle, top + 17f)
    val stands = tone(standing)
    line(stands, middle - 1.5f, top + 19f, middle - 1.5f, top + 27f)
    line(stands, middle + 1.5f, top + 19f, middle + 1.5f, top + 27f)
    val walks = tone(walking)
    line(walks, middle - 1.5f, top + 18.5f, middle - 5f, top + 27f)
    line(walks, middle + 1.5f, top + 18.5f, middle + 5f, top + 27f)
    line(walks, middle, top + 10f, middle - 5f, top + 14f)
    line(walks, middle, top + 10f, middle + 5f, top + 14f)
}

/** Data log, transfer dots, battery and infrared, in one row. */
internal fun DrawScope.drawStatus(glass: LcdGlass) {
    QUARTERS.forEachIndexed { quarter, icon ->
        drawArc(
            tone(glass.isLit(icon)), quarter * 90f - 88f, 86f, true,
            LcdPlan.DATALOG - Offset(6f, 6f), Size(12f, 12f),
        )
    }
    for ((icon, x) in DOTS.zip(LcdPlan.DOTS)) drawCircle(tone(glass.isLit(icon)), 2f, Offset(x, LcdPlan.STATUS_ROW))
    val battery = tone(glass.isLit(LcdIcon.LOW_BATTERY))
    drawRect(battery, LcdPlan.BATTERY.topLeft, LcdPlan.BATTERY.size, style = Stroke(1.4f))
    drawRect(battery, LcdPlan.BATTERY.centerRight + Offset(0.8f, -2f), Size(1.8f, 4f))
    line(battery, LcdPlan.BATTERY.left - 1f, LcdPlan.BATTERY.bottom + 2f, LcdPlan.BATTERY.right + 1f, LcdPlan.BATTERY.top - 2f)
    drawWave(glass.isLit(LcdIcon.INFRARED_SHORT), 5f)
    drawWave(glass.isLit(LcdIcon.INFRARED_LONG), 9f)
}

/** What points at the ports: sensors above, motors below. */
internal fun DrawScope.drawPortMarks(glass: LcdGlass) {
    LcdPlan.PORT_COLUMNS.forEachIndexed { column, x ->
        val (view, active) = SENSORS[column]
        triangle(tone(glass.isLit(view)), Offset(x, LcdPlan.SENSOR_ROW - 6f), Offset(-4.5f, 8f), Offset(4.5f, 8f))
        line(tone(glass.isLit(active)), x - 4f, LcdPlan.SENSOR_ROW + 7f, x + 4f, LcdPlan.SENSOR_ROW + 7f)
        val (shown, backward, forward) = MOTORS[column]
        val y = LcdPlan.MOTOR_ROW
        triangle(tone(glass.isLit(shown)), Offset(x, y + 6f), Offset(-3.5f, -8f), Offset(3.5f, -8f))
        triangle(tone(glass.isLit(backward)), Offset(x - 13f, y), Offset(7f, -4.5f), Offset(7f, 4.5f))
        triangle(tone(glass.isLit(forward)), Offset(x + 13f, y), Offset(-7f, -4.5f), Offset(-7f, 4.5f))
    }
}

private fun DrawScope.drawWave(lit: Boolean, radius: Float) = drawArc(
    tone(lit), -50f, 100f, false, LcdPlan.INFRARED - Offset(radius, radius), Size(2 * radius, 2 * radius),
    style = Stroke(1.8f, cap = StrokeCap.Round),
)

private fun DrawScope.line(colour: Color, fromX: Float, fromY: Float, toX: Float, toY: Float) =
    drawLine(colour, Offset(fromX, fromY), Offset(toX, toY), 2f, StrokeCap.Round)

private fun DrawScope.triangle(colour: Color, tip: Offset, toSecond: Offset, toThird: Offset) {
    val path = Path().apply {
        moveTo(tip.x, tip.y)
        lineTo(tip.x + toSecond.x, tip.y + toSecond.y)
        lineTo(tip.x + toThird.x, tip.y + toThird.y)
        close()
    }
    drawPath(path, colour)
}

/** Clockwise from the top, as the arcs are drawn. */
private val QUARTERS =
    listOf(LcdIcon.DATALOG_TOP_RIGHT, LcdIcon.DATALOG_BOTTOM_RIGHT, LcdIcon.DATALOG_BOTTOM_LEFT, LcdIcon.DATALOG_TOP_LEFT)

private val DOTS = listOf(LcdIcon.DOT_1, LcdIcon.DOT_2, LcdIcon.DOT_3, LcdIcon.DOT_4, LcdIcon.DOT_5)

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
