package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.lerp
import robotran.ui.common.BrickColours
import robotran.uikit.*

/** A two by two plate with four contact studs, like the plug of a cable; fills the draw area. */
internal fun DrawScope.drawPort(colour: Color) {
    val unit = size.width / PORT_UNITS
    val edge = lerp(colour, RobotranColours.SHADE, 0.35f)
    drawRoundRect(
        colour,
        Offset(unit, unit),
        Size(size.width - 2 * unit, size.height - 2.5f * unit),
        CornerRadius(6 * unit),
    )
    for (x in STUD_PLACES) {
        for (y in STUD_PLACES) {
            val middle = Offset(x * unit, y * unit)
            drawCircle(lerp(colour, RobotranColours.ON_COLOUR, 0.18f), 7 * unit, middle, alpha = 0.25f)
            drawCircle(edge, 7 * unit, middle, alpha = 0.3f, style = Stroke(unit))
        }
    }
}

/** A triangle that points up for forward and down for backward; fills the draw area. */
internal fun DrawScope.drawDirectionArrow(forward: Boolean) {
    val tip = if (forward) 0f else size.height
    val base = size.height - tip
    val arrow = Path().apply {
        moveTo(size.width / 2, tip)
        lineTo(size.width, base)
        lineTo(0f, base)
        close()
    }
    drawPath(arrow, BrickColours.LABEL)
}

private const val PORT_UNITS = 54f
private val STUD_PLACES = listOf(13f, 41f)
