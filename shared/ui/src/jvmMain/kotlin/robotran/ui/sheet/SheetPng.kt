package robotran.ui.sheet

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asSkiaBitmap
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.font.createFontFamilyResolver
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import robotran.world.SessionState
import robotran.world.World

/** The picture of [renderSheet] as the bytes of a PNG file; needs no screen. */
fun sheetPng(world: World, state: SessionState, widthPixels: Int = PICTURE_PIXELS, colours: SheetColours = SheetColours.LIGHT): ByteArray =
    pngOf(renderSheet(world, state, widthPixels, pictureLabels(), colours))

/** The bytes of a PNG file with [picture]. */
fun pngOf(picture: ImageBitmap): ByteArray = Image.makeFromBitmap(picture.asSkiaBitmap()).use { image ->
    checkNotNull(image.encodeToData(EncodedImageFormat.PNG)) { "Skia could not encode the picture" }.bytes
}

/** Writes in pictures as on a screen. */
private fun pictureLabels() = TextMeasurer(createFontFamilyResolver(), Density(1f), LayoutDirection.Ltr)
