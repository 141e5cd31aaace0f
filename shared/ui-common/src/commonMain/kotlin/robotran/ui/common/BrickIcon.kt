package robotran.ui.common

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.withTransform
import androidx.compose.ui.graphics.painter.Painter
import robotran.uikit.*

/** The app icon: a brick with its display and the four buttons, simplified for a task bar. */
class BrickIcon : Painter() {
    override val intrinsicSize = Size(UNITS, UNITS)

    override fun DrawScope.onDraw() {
        val unit = size.minDimension / UNITS
        withTransform({ scale(unit, unit, Offset.Zero) }) {
            block(RobotranColours.YELLOW, Offset(10f, 2f), Size(44f, 60f), 8f)
            block(BrickColours.GLASS, Offset(22f, 24f), Size(20f, 16f), 3f)
            block(BrickColours.SEGMENT, Offset(26f, 31f), Size(12f, 2.5f), 1f)
            for (x in listOf(17f, 32f, 47f)) {
                drawCircle(BrickColours.INPUT, 4.5f, Offset(x, 12f))
                drawCircle(BrickColours.OUTPUT, 4.5f, Offset(x, 52f))
            }
            button(BrickColours.VIEW, 16.5f, 27f)
            button(RobotranColours.ON_OFF_RED, 16.5f, 38f)
            button(BrickColours.FACE, 47.5f, 27f)
            button(RobotranColours.RUN_GREEN, 47.5f, 38f)
        }
    }

    private fun DrawScope.button(colour: Color, x: Float, y: Float) = drawCircle(colour, 4f, Offset(x, y))

    private fun DrawScope.block(colour: Color, corner: Offset, size: Size, radius: Float) =
        drawRoundRect(colour, corner, size, CornerRadius(radius))

    private companion object {
        const val UNITS = 64f
    }
}
