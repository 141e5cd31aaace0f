package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdIcon
import robotran.ui.common.BrickColours
import robotran.uikit.*

/** The glass of the display; fills the draw area. Unlit segments are drawn faintly, as on a real one. */
internal fun DrawScope.drawLcd(glass: LcdGlass) {
    val unit = size.width / LcdPlan.WIDTH
    withTransform({ scale(unit, unit, Offset.Zero) }) {
        drawRoundRect(
            BrickColours.GLASS_EDGE,
            Offset(-5f, -5f),
            Size(LcdPlan.WIDTH + 10, LcdPlan.HEIGHT + 10),
            CornerRadius(12f),
        )
        drawRoundRect(BrickColours.GLASS, Offset.Zero, Size(LcdPlan.WIDTH, LcdPlan.HEIGHT), CornerRadius(8f))
        drawDigits(glass)
        for ((icon, shape) in lcdIconShapes) drawPath(shape, tone(glass.isLit(icon)))
    }
}

/** Only the row of digits, as wide as the draw area. */
internal fun DrawScope.drawLcdNumbers(glass: LcdGlass) {
    val width = NUMBERS.width + 2 * NUMBERS_MARGIN
    val unit = size.width / width
    drawRoundRect(BrickColours.GLASS_EDGE, Offset.Zero, size, CornerRadius(12f * unit))
    val edge = 3 * unit
    drawRoundRect(
        BrickColours.GLASS,
        Offset(edge, edge),
        Size(size.width - 2 * edge, size.height - 2 * edge),
        CornerRadius(9f * unit),
    )
    withTransform({
        translate((NUMBERS_MARGIN - NUMBERS.left) * unit, size.height / 2 - NUMBERS.center.y * unit)
        scale(unit, unit, Offset.Zero)
    }) {
        drawDigits(glass)
        for (icon in SIGNS) drawPath(lcdIconShapes.getValue(icon), tone(glass.isLit(icon)))
    }
}

private fun DrawScope.drawDigits(glass: LcdGlass) {
    LcdPlan.DIGITS.forEachIndexed { position, place -> drawDigit(glass.digit(position), place) }
    val standing = glass.isLit(LcdIcon.STANDING_MAN)
    val walking = glass.isLit(LcdIcon.WALKING_MAN)
    drawPath(LcdMen.body, tone(standing || walking))
    drawPath(LcdMen.standing, tone(standing))
    drawPath(LcdMen.walking, tone(walking))
}

/** The colour of a segment on the glass. */
internal fun tone(highlighted: Boolean): Color = if (highlighted) BrickColours.SEGMENT else BrickColours.GHOST

/** From the minus sign to the program digit. */
private val NUMBERS = Rect(LcdPlan.MINUS.left, LcdPlan.DIGITS[0].top, LcdPlan.DIGITS[0].right, LcdPlan.DIGITS[0].bottom)
private const val NUMBERS_MARGIN = 9f
private val SIGNS = listOf(LcdIcon.MINUS, LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)
