package robotran.ui.sheet

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.IntRect
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.dp
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Everything below the ink that never moves, drawn once for each size and theme: paper with its grain, marks, template,
 * and the shadows of the walls. A frame only copies it, so all that costs less than the plain paper did. Of a sheet
 * that is zoomed far in, it holds what the window shows and a margin around that, so that panning seldom draws it
 * again.
 */
internal class GroundPicture(private val drawing: SheetDrawing) {
    private var latest: Made? = null

    /**
     * Draws what is [visible] of it, in the pixels of the drawing.
     *
     * @param isStretched whether it is shown in another size for a moment.
     */
    fun draw(scope: DrawScope, colours: SheetColours, grain: ImageBitmap, visible: Rect, isStretched: Boolean) {
        val all = extent(scope)
        val needed = wholePixels(all.intersect(visible)) ?: return
        val made = latest?.takeIf { it.colours == colours && it.grain === grain && it.area.covers(needed) }
            ?: make(scope, colours, grain, chooseArea(needed, wholePixels(all) ?: return)).also { latest = it }
        scope.drawImage(
            made.picture,
            dstOffset = made.area.topLeft,
            dstSize = IntSize(made.picture.width, made.picture.height),
            filterQuality = if (isStretched) FilterQuality.Low else FilterQuality.None,
        )
    }

    /** The paper with all shadows. */
    private fun extent(scope: DrawScope): Rect {
        val paper = drawing.transform.paper.inflate(with(scope) { MARGIN.toPx() })
        val solids = drawing.solids.outline.path.getBounds()
        if (solids.isEmpty) return paper
        val shade = solids.translate(solidShadow(drawing.transform)).inflate(1f)
        return Rect(
            minOf(paper.left, shade.left),
            minOf(paper.top, shade.top),
            maxOf(paper.right, shade.right),
            maxOf(paper.bottom, shade.bottom),
        )
    }

    private fun chooseArea(needed: IntRect, all: IntRect): IntRect {
        if (pixelsOf(all) <= MAX_PIXELS) return all
        val spare = needed.inflate(minOf(needed.width, needed.height) / SPARE).intersect(all)
        return if (pixelsOf(spare) <= MAX_PIXELS) spare else needed
    }

    private fun make(scope: DrawScope, colours: SheetColours, grain: ImageBitmap, area: IntRect): Made {
        val picture = ImageBitmap(area.width, area.height, hasAlpha = false)
        val size = Size(area.width.toFloat(), area.height.toFloat())
        CanvasDrawScope().draw(scope, scope.layoutDirection, Canvas(picture), size) {
            drawRect(colours.desk)
            translate(-area.left.toFloat(), -area.top.toFloat()) {
                val part = Rect(
                    area.left.toFloat(),
                    area.top.toFloat(),
                    area.right.toFloat(),
                    area.bottom.toFloat(),
                )
                drawGround(drawing, colours, grain, part)
            }
        }
        return Made(picture.finished(), area, colours, grain)
    }

    private class Made(val picture: ImageBitmap, val area: IntRect, val colours: SheetColours, val grain: ImageBitmap)

    private companion object {
        /** Room for the shadow of the paper. */
        val MARGIN = 12.dp

        /** 16 MB, unless a window shows more. */
        const val MAX_PIXELS = 4_000_000L

        /** The part of the window that is drawn beyond its edges. */
        const val SPARE = 4

        fun pixelsOf(area: IntRect): Long = area.width.toLong() * area.height

        fun IntRect.covers(other: IntRect): Boolean =
            left <= other.left && top <= other.top && right >= other.right && bottom >= other.bottom

        /** [area] with whole edges; null for nothing. */
        fun wholePixels(area: Rect): IntRect? {
            if (area.isEmpty) return null
            val corner = IntOffset(floor(area.left).toInt(), floor(area.top).toInt())
            return IntRect(corner, IntSize(ceil(area.right).toInt() - corner.x, ceil(area.bottom).toInt() - corner.y))
        }
    }
}
