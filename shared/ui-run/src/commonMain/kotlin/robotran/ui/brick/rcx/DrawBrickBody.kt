package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.ui.common.BrickColours
import robotran.uikit.*

/**
 * The yellow case with its studs, the infrared window and the grey plate below the display and the buttons.
 *
 * @param sending whether the infrared lamps are highlighted.
 */
internal fun DrawScope.drawBrickBody(sending: Boolean) {
    val unit = size.width / BrickPlan.WIDTH
    withTransform({ scale(unit, unit, Offset.Zero) }) {
        val whole = Rect(0f, 0f, BrickPlan.WIDTH, BrickPlan.HEIGHT)
        block(whole, BrickColours.EDGE, BrickPlan.CORNER)
        block(whole.deflate(2f).translate(0f, -1f), RobotranColours.YELLOW, BrickPlan.CORNER)
        for ((x, y) in BrickPlan.STUDS) drawStud(Offset(x, y))
        block(BrickPlan.INFRARED_WINDOW, if (sending) BrickColours.INFRARED_SENDING else BrickColours.INFRARED, 10f)
        block(Rect(80f, 20f, 184f, 30f), BrickColours.INFRARED_SHEEN, 5f)
        if (sending) for (x in BrickPlan.INFRARED_LAMPS) drawCircle(BrickColours.INFRARED_LAMP, 5f, Offset(x, 38f))
        block(BrickPlan.FACE, BrickColours.FACE, 14f)
    }
}

private fun DrawScope.drawStud(middle: Offset) {
    drawCircle(BrickColours.EDGE, BrickPlan.STUD_RADIUS, middle + Offset(0f, 1.5f))
    drawCircle(BrickColours.STUD_LIGHT, BrickPlan.STUD_RADIUS - 0.5f, middle)
    drawCircle(RobotranColours.YELLOW, BrickPlan.STUD_RADIUS - 2f, middle)
    drawCircle(BrickColours.EDGE.copy(alpha = 0.35f), BrickPlan.STUD_RADIUS - 0.5f, middle, style = Stroke(1f))
}

private fun DrawScope.block(bounds: Rect, colour: Color, corner: Float) =
    drawRoundRect(colour, bounds.topLeft, Size(bounds.width, bounds.height), CornerRadius(corner))
