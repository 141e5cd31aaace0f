package robotran.ui.pictures

import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asSkiaBitmap
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.font.createFontFamilyResolver
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image

actual fun pngOf(picture: ImageBitmap): ByteArray = Image.makeFromBitmap(picture.asSkiaBitmap()).use { image ->
    checkNotNull(image.encodeToData(EncodedImageFormat.PNG)) { "Skia could not encode the picture" }.bytes
}

actual fun pictureFonts(): FontFamily.Resolver? = createFontFamilyResolver()
