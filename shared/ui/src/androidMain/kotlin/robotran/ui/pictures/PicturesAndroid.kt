package robotran.ui.pictures

import android.graphics.Bitmap
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.asAndroidBitmap
import androidx.compose.ui.text.font.FontFamily
import java.io.ByteArrayOutputStream

actual fun pngOf(picture: ImageBitmap): ByteArray = ByteArrayOutputStream().use { bytes ->
    // A PNG loses nothing, so the quality does not matter.
    check(picture.asAndroidBitmap().compress(Bitmap.CompressFormat.PNG, 100, bytes)) {
        "The picture could not be encoded"
    }
    bytes.toByteArray()
}

/** An activity has them. */
actual fun pictureFonts(): FontFamily.Resolver? = null
