package robotran.ui.pictures

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import robotran.simulation.picture.WorldPictures
import robotran.simulation.state.SessionState
import robotran.ui.sheet.PICTURE_PIXELS
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.renderSheet
import robotran.ui.sheet.svg.SheetSvg
import robotran.world.World

/**
 * A picture of [world] as it stands in [state], as the bytes of a PNG file.
 *
 * @param fonts what names and numbers are written with; null where a platform has none without a screen, and then they
 * are left out.
 */
fun worldPicturePng(world: World, state: SessionState, fonts: FontFamily.Resolver? = pictureFonts()): ByteArray =
    pngOf(renderSheet(world, state, PICTURE_PIXELS, fonts?.let(::labelsWith)))

/**
 * The same as the text of an SVG file, with lines that stay crisp at any size; in it the lamps' light has no shadows.
 * The same on every platform.
 */
fun worldPictureSvg(world: World, state: SessionState): String = SheetSvg(world, state).write()

/**
 * The pictures that this module draws.
 *
 * @param fonts what names and numbers are written with; null where a platform has none without a screen.
 */
class DrawnWorldPictures(private val fonts: () -> FontFamily.Resolver? = ::pictureFonts) : WorldPictures {
    override fun png(world: World, state: SessionState): ByteArray = worldPicturePng(world, state, fonts())

    override fun svg(world: World, state: SessionState): String = worldPictureSvg(world, state)
}

/** The picture of [renderSheet] as the bytes of a PNG file; needs no screen. */
fun sheetPng(
    world: World,
    state: SessionState,
    widthPixels: Int = PICTURE_PIXELS,
    colours: SheetColours = SheetColours.LIGHT,
): ByteArray = pngOf(renderSheet(world, state, widthPixels, pictureFonts()?.let(::labelsWith), colours))

/** The bytes of a PNG file with [picture]. */
expect fun pngOf(picture: ImageBitmap): ByteArray

/** The fonts of pictures that are drawn without a screen; null where the platform has them only on a screen. */
expect fun pictureFonts(): FontFamily.Resolver?

/** Writes in pictures as on a screen. */
private fun labelsWith(fonts: FontFamily.Resolver) = TextMeasurer(fonts, Density(1f), LayoutDirection.Ltr)
