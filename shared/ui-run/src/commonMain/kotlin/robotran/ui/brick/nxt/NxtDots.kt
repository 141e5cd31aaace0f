package robotran.ui.brick.nxt

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Paint
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.IntSize
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.NxtDisplay
import kotlin.math.floor
import kotlin.math.min

/** The dots of the display, a pixel each, on nothing. */
internal fun dotsOf(display: NxtDisplay): ImageBitmap {
    val picture = ImageBitmap(DisplaySize.WIDTH, DisplaySize.HEIGHT)
    val canvas = Canvas(picture)
    val paint = Paint().apply {
        color = NxtColours.DOT
        isAntiAlias = false
    }
    for (y in 0..<DisplaySize.HEIGHT) {
        var x = 0
        while (x < DisplaySize.WIDTH) {
            val from = x
            while (display.isBlack(x, y)) x++
            if (x > from) canvas.drawRect(Rect(from.toFloat(), y.toFloat(), x.toFloat(), y + 1f), paint)
            x++
        }
    }
    return picture
}

/**
 * The glass with [count] rows of dots of [dots] from the row [first] on, in the middle of the draw area. A dot has a
 * whole number of pixels, so that all dots look alike, unless that left much of the area empty.
 *
 * @param contrast from 0, no dots, to 1.
 * @param margin around the dots at most, in pixels.
 */
internal fun DrawScope.drawGlass(
    dots: ImageBitmap,
    first: Int,
    count: Int,
    contrast: Float,
    margin: Float,
    isOn: Boolean,
    gap: Int = 0,
) {
    val rows = count / DisplaySize.CELL_HEIGHT
    val gaps = gap * (rows - 1)
    val most = min(size.width / DisplaySize.WIDTH, size.height / (count + gaps))
    val whole = floor(most)
    val scale = if (whole >= SMALLEST_WHOLE * most) whole else most
    val width = (DisplaySize.WIDTH * scale).toInt()
    val height = ((count + gaps) * scale).toInt()
    val left = ((size.width - width) / 2).toInt()
    val top = ((size.height - height) / 2).toInt()
    val glass = Rect(left.toFloat(), top.toFloat(), (left + width).toFloat(), (top + height).toFloat()).inflate(margin)
        .intersect(Rect(Offset.Zero, size))
    drawRoundRect(
        if (isOn) NxtColours.GLASS else NxtColours.GLASS_OFF,
        glass.topLeft,
        Size(glass.width, glass.height),
        CornerRadius(margin / 2),
    )
    val pieces = if (gap == 0) 1 else rows
    val piece = count / pieces
    for (number in 0..<pieces) {
        drawImage(
            dots,
            IntOffset(0, first + number * piece),
            IntSize(DisplaySize.WIDTH, piece),
            IntOffset(left, top + (number * (piece + gap) * scale).toInt()),
            IntSize(width, (piece * scale).toInt()),
            alpha = contrast,
            filterQuality = FilterQuality.None,
        )
    }
}

/** A smaller part of the area may be left empty to keep the dots alike. */
private const val SMALLEST_WHOLE = 0.72f
