package robotran.ui.pictures

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.simulation.picture.WorldFrames
import robotran.simulation.picture.WorldPictures
import robotran.simulation.state.SessionState
import robotran.ui.sheet.PICTURE_PIXELS
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.renderSheet
import robotran.ui.sheet.svg.SheetSvg
import robotran.world.World

/**
 * A picture of [world] in [state] as a PNG file.
 *
 * @param fonts for names and numbers; they are omitted if null, on platforms without fonts off screen.
 */
fun worldPicturePng(world: World, state: SessionState, fonts: FontFamily.Resolver? = pictureFonts()): ByteArray =
    pngOf(renderSheet(world, state, PICTURE_PIXELS, fonts?.let(::labelsWith)))

/**
 * The same as an SVG file, which scales without loss, without the soft shadows of what stands. The result is the same on
 * every platform.
 */
fun worldPictureSvg(world: World, state: SessionState): String = SheetSvg(world, state).write()

/**
 * The pictures drawn by this module.
 *
 * @param fonts for names and numbers; null on platforms without fonts off screen.
 */
class DrawnWorldPictures(private val fonts: () -> FontFamily.Resolver? = ::pictureFonts) : WorldPictures {
    override fun png(world: World, state: SessionState): ByteArray = worldPicturePng(world, state, fonts())

    override fun svg(world: World, state: SessionState): String = worldPictureSvg(world, state)

    override fun frames(world: World, maxSide: Int): WorldFrames =
        DrawnFrames(world, maxSide, fonts()?.let(::labelsWith))
}

/** The picture of [renderSheet] as a PNG file; works off screen. */
fun sheetPng(
    world: World,
    state: SessionState,
    widthPixels: Int = PICTURE_PIXELS,
    colours: SheetColours = SheetColours.LIGHT,
): ByteArray = pngOf(renderSheet(world, state, widthPixels, pictureFonts()?.let(::labelsWith), colours))

/** [picture] as a PNG file. */
expect fun pngOf(picture: ImageBitmap): ByteArray

/** The fonts for off-screen pictures; null if the platform has fonts only on screen. */
expect fun pictureFonts(): FontFamily.Resolver?

/** Measures text in pictures like on screen. */
internal fun labelsWith(fonts: FontFamily.Resolver) = TextMeasurer(fonts, Density(1f), LayoutDirection.Ltr)
