package robotran.ui.brick.rcx

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope

/** Seven segments in [bounds]. [mask] has the bits of [robotran.rcxrom.display.LcdGlass.digit]. */
internal fun DrawScope.drawDigit(mask: Int, bounds: Rect) {
    segments(bounds).forEachIndexed { bit, segment -> drawPath(segment, tone(mask shr bit and 1 == 1)) }
}

/** In the order of the mask's bits: middle, top right, top, top left, bottom left, bottom, bottom right. */
private fun segments(bounds: Rect): List<Path> {
    val left = bounds.left + HALF
    val right = bounds.right - HALF
    val top = bounds.top + HALF
    val bottom = bounds.bottom - HALF
    val middle = bounds.center.y
    return listOf(
        horizontal(left, right, middle),
        vertical(right, top, middle),
        horizontal(left, right, top),
        vertical(left, top, middle),
        vertical(left, middle, bottom),
        horizontal(left, right, bottom),
        vertical(right, middle, bottom),
    )
}

private fun horizontal(left: Float, right: Float, y: Float): Path = Path().apply {
    moveTo(left + GAP, y)
    lineTo(left + GAP + HALF, y - HALF)
    lineTo(right - GAP - HALF, y - HALF)
    lineTo(right - GAP, y)
    lineTo(right - GAP - HALF, y + HALF)
    lineTo(left + GAP + HALF, y + HALF)
    close()
}

private fun vertical(x: Float, top: Float, bottom: Float): Path = Path().apply {
    moveTo(x, top + GAP)
    lineTo(x + HALF, top + GAP + HALF)
    lineTo(x + HALF, bottom - GAP - HALF)
    lineTo(x, bottom - GAP)
    lineTo(x - HALF, bottom - GAP - HALF)
    lineTo(x - HALF, top + GAP + HALF)
    close()
}

/** Half the thickness of a segment, and the gap between two, in units of the [LcdPlan]. */
private const val HALF = 3f
private const val GAP = 0.7f
