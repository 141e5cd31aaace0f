package robotran.ui.pictures

import android.graphics.Bitmap
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asAndroidBitmap
import androidx.compose.ui.text.font.FontFamily
import java.io.ByteArrayOutputStream

actual fun pngOf(picture: ImageBitmap): ByteArray = ByteArrayOutputStream().use { bytes ->
    // PNG is lossless, so the quality has no effect.
    check(picture.asAndroidBitmap().compress(Bitmap.CompressFormat.PNG, 100, bytes)) {
        "The picture could not be encoded"
    }
    bytes.toByteArray()
}

/** Only an activity provides fonts. */
actual fun pictureFonts(): FontFamily.Resolver? = null
