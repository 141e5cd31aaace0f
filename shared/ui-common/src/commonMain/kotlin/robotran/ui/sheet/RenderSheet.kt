package robotran.ui.sheet

import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.simulation.state.SessionState
import robotran.world.World
import kotlin.math.roundToInt

/**
 * Renders the sheet off screen as the screen shows it, in light [colours] by default.
 *
 * @param widthPixels the width, from 1 to [MAX_PICTURE_PIXELS]; the height follows from the paper.
 * @param density pixels per dp, for line widths with a minimum in dp.
 * @param labels measures the robots' names and the goals' numbers; null omits them.
 */
fun renderSheet(
    world: World,
    state: SessionState,
    widthPixels: Int = PICTURE_PIXELS,
    labels: TextMeasurer? = null,
    colours: SheetColours = SheetColours.LIGHT,
    density: Float = 1f,
): ImageBitmap = renderOn(world, widthPixels, density) { drawing -> drawSheet(drawing, state, colours, labels) }

/** A picture of the size of [world]'s sheet, drawn by [draw]. */
internal fun renderOn(
    world: World,
    widthPixels: Int,
    density: Float = 1f,
    draw: DrawScope.(SheetDrawing) -> Unit,
): ImageBitmap {
    require(widthPixels in 1..MAX_PICTURE_PIXELS) {
        "A picture is 1 to $MAX_PICTURE_PIXELS pixels wide, not $widthPixels"
    }
    val paper = world.paper
    val wide = paper.width + 2 * PICTURE_MARGIN_CENTIMETRES
    val high = paper.height + 2 * PICTURE_MARGIN_CENTIMETRES
    val heightPixels = (widthPixels * high / wide).roundToInt().coerceIn(1, MAX_PICTURE_PIXELS)
    val size = Size(widthPixels.toFloat(), heightPixels.toFloat())
    val drawing = SheetFit(world, PICTURE_MARGIN_CENTIMETRES).into(size)
    val image = ImageBitmap(widthPixels, heightPixels)
    CanvasDrawScope().draw(Density(density), LayoutDirection.Ltr, Canvas(image), size) {
        draw(drawing)
    }
    return image
}

/** The default and the max width of a picture. */
const val PICTURE_PIXELS = 1200
const val MAX_PICTURE_PIXELS = 8192

/** The desk around the paper in a picture. */
private const val PICTURE_MARGIN_CENTIMETRES = 2.0
