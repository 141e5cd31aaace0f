package robotran.ui.pictures

import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.simulation.picture.WorldFrames
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetFit
import robotran.ui.sheet.drawSheet
import robotran.world.World
import kotlin.math.roundToInt

/** Draws frames as the screen shows the sheet in the light theme, always into the same bitmap. */
internal class DrawnFrames(world: World, maxSide: Int, private val labels: TextMeasurer?) : WorldFrames {
    override val width: Int
    override val height: Int
    private val fit = SheetFit(world, MARGIN_CENTIMETRES)
    private val image: ImageBitmap
    private val canvas: Canvas

    init {
        val wide = world.paper.width + 2 * MARGIN_CENTIMETRES
        val high = world.paper.height + 2 * MARGIN_CENTIMETRES
        val scale = maxSide / maxOf(wide, high)
        width = (wide * scale).roundToInt().coerceIn(1, maxSide)
        height = (high * scale).roundToInt().coerceIn(1, maxSide)
        image = ImageBitmap(width, height)
        canvas = Canvas(image)
    }

    override fun draw(state: SessionState, pixels: IntArray) {
        val size = Size(width.toFloat(), height.toFloat())
        // The desk fills all of it, so nothing of the last frame remains.
        CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, canvas, size) {
            drawSheet(fit.into(size), state, SheetColours.LIGHT, labels)
        }
        image.readPixels(pixels)
    }

    private companion object {
        /** The desk around the paper. */
        const val MARGIN_CENTIMETRES = 2.0
    }
}
