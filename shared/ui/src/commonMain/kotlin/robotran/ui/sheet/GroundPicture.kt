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
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.dp
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Everything below the ink that never moves, drawn once for each size and theme: paper with its grain, marks, template,
 * and the shadows of the walls. A frame only copies it, so all that costs less than the plain paper did.
 */
internal class GroundPicture(private val drawing: SheetDrawing) {
    private var latest: Made? = null

    /**
     * Draws it, and returns true; false if it would be too large, as for a sheet that is zoomed far in.
     *
     * @param isStretched whether it is shown in another size for a moment.
     */
    fun draw(scope: DrawScope, colours: SheetColours, grain: ImageBitmap, isStretched: Boolean): Boolean {
        val made = latest?.takeIf { it.colours == colours && it.grain === grain }
            ?: make(scope, colours, grain)?.also { latest = it }
            ?: return false
        scope.drawImage(
            made.picture,
            dstOffset = made.place,
            dstSize = IntSize(made.picture.width, made.picture.height),
            filterQuality = if (isStretched) FilterQuality.Low else FilterQuality.None,
        )
        return true
    }

    private fun make(scope: DrawScope, colours: SheetColours, grain: ImageBitmap): Made? {
        val area = drawing.transform.paper.inflate(with(scope) { MARGIN.toPx() })
        val place = IntOffset(floor(area.left).toInt(), floor(area.top).toInt())
        val size = Size(ceil(area.right) - place.x, ceil(area.bottom) - place.y)
        if (size.width * size.height > MAX_PIXELS) return null
        val picture = ImageBitmap(size.width.toInt(), size.height.toInt(), hasAlpha = false)
        CanvasDrawScope().draw(scope, scope.layoutDirection, Canvas(picture), size) {
            drawRect(colours.desk)
            translate(-place.x.toFloat(), -place.y.toFloat()) {
                val all = Rect(place.x.toFloat(), place.y.toFloat(), place.x + size.width, place.y + size.height)
                drawGround(drawing, colours, grain, all)
            }
        }
        return Made(picture, place, colours, grain)
    }

    private class Made(
        val picture: ImageBitmap,
        val place: IntOffset,
        val colours: SheetColours,
        val grain: ImageBitmap,
    )

    private companion object {
        /** Room for the shadow of the paper. */
        val MARGIN = 12.dp

        /** 16 MB; more than the largest window shows. */
        const val MAX_PIXELS = 4_000_000f
    }
}
