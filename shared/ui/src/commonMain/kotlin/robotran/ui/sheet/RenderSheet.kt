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
 * A picture of the sheet as the screen shows it, by day unless [colours] say otherwise; needs no screen.
 *
 * @param widthPixels how wide it is to be; its height follows from the paper. At least 1, at most [MAX_PICTURE_PIXELS].
 * @param density how many of these pixels a line that is never to be thinner than so many dp takes for one of them.
 * @param labels what the robots' names and the numbers of goals are written with; null for leaving them out.
 */
fun renderSheet(
    world: World,
    state: SessionState,
    widthPixels: Int = PICTURE_PIXELS,
    labels: TextMeasurer? = null,
    colours: SheetColours = SheetColours.LIGHT,
    density: Float = 1f,
): ImageBitmap = renderOn(world, widthPixels, density) { drawing -> drawSheet(drawing, state, colours, labels) }

/** A picture with room for the sheet of [world], drawn by [draw]. */
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

/** How wide a picture is unless said otherwise, and how wide it can be at most. */
const val PICTURE_PIXELS = 1200
const val MAX_PICTURE_PIXELS = 8192

/** The desk around the paper in a picture. */
private const val PICTURE_MARGIN_CENTIMETRES = 2.0
