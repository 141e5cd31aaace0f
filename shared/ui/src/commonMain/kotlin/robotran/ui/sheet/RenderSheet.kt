package robotran.ui.sheet

import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.world.SessionState
import robotran.world.World
import kotlin.math.roundToInt

/**
 * A picture of the sheet, as the screen shows it by day; needs no screen.
 *
 * @param widthPixels how wide it is to be; its height follows from the paper. At least 1, at most [MOST_PICTURE_PIXELS].
 */
fun renderSheet(world: World, state: SessionState, widthPixels: Int = PICTURE_PIXELS): ImageBitmap {
    require(widthPixels in 1..MOST_PICTURE_PIXELS) { "A picture is 1 to $MOST_PICTURE_PIXELS pixels wide, not $widthPixels" }
    val paper = world.paper
    val wide = paper.width + 2 * PICTURE_MARGIN_CENTIMETRES
    val high = paper.height + 2 * PICTURE_MARGIN_CENTIMETRES
    val heightPixels = (widthPixels * high / wide).roundToInt().coerceIn(1, MOST_PICTURE_PIXELS)
    val size = Size(widthPixels.toFloat(), heightPixels.toFloat())
    val transform = SheetTransform.fitting(paper.width, paper.height, PICTURE_MARGIN_CENTIMETRES, size)
    val image = ImageBitmap(widthPixels, heightPixels)
    CanvasDrawScope().draw(Density(1f), LayoutDirection.Ltr, Canvas(image), size) {
        drawSheet(world, state, SheetColours.LIGHT, transform)
    }
    return image
}

/** How wide a picture is unless said otherwise, and how wide it can be at most. */
const val PICTURE_PIXELS = 1200
const val MOST_PICTURE_PIXELS = 8192

/** The desk around the paper in a picture. */
private const val PICTURE_MARGIN_CENTIMETRES = 2.0
