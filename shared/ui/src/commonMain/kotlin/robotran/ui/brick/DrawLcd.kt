package robotran.ui.brick

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.rom.LcdGlass
import robotran.rom.LcdIcon

/** The glass of the display; fills the draw area. Segments that are not lit leave a faint ghost, as on a real one. */
internal fun DrawScope.drawLcd(glass: LcdGlass) {
    val unit = size.width / LcdPlan.WIDTH
    withTransform({ scale(unit, unit, Offset.Zero) }) {
        drawRoundRect(BrickColours.GLASS_EDGE, Offset(-3f, -3f), Size(LcdPlan.WIDTH + 6, LcdPlan.HEIGHT + 6), CornerRadius(8f))
        drawRoundRect(BrickColours.GLASS, Offset.Zero, Size(LcdPlan.WIDTH, LcdPlan.HEIGHT), CornerRadius(5f))
        drawNumbers(glass)
        drawStatus(glass)
        drawPortMarks(glass)
    }
}

/** Only the row of digits, as wide as the draw area. */
internal fun DrawScope.drawLcdNumbers(glass: LcdGlass) {
    val unit = size.width / LcdPlan.WIDTH
    drawRoundRect(BrickColours.GLASS_EDGE, Offset.Zero, size, CornerRadius(8f * unit))
    val edge = 2 * unit
    drawRoundRect(BrickColours.GLASS, Offset(edge, edge), Size(size.width - 2 * edge, size.height - 2 * edge), CornerRadius(6f * unit))
    val top = (size.height - LcdPlan.MAN.height * unit) / 2 - LcdPlan.MAN.top * unit
    withTransform({
        translate(0f, top)
        scale(unit, unit, Offset.Zero)
    }) { drawNumbers(glass) }
}

private fun DrawScope.drawNumbers(glass: LcdGlass) {
    LcdPlan.DIGITS.forEachIndexed { position, place -> drawDigit(glass.digit(position), place) }
    drawRect(tone(glass.isLit(LcdIcon.MINUS)), LcdPlan.MINUS.topLeft, LcdPlan.MINUS.size)
    for ((icon, middle) in POINTS.zip(LcdPlan.POINTS)) drawCircle(tone(glass.isLit(icon)), 1.6f, middle)
    drawMan(glass.isLit(LcdIcon.STANDING_MAN), glass.isLit(LcdIcon.WALKING_MAN))
}

/** The colour of a segment on the glass. */
internal fun tone(lit: Boolean): Color = if (lit) BrickColours.SEGMENT else BrickColours.GHOST

private val POINTS = listOf(LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)
