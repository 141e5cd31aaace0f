package robotran.ui.sheet

import androidx.compose.ui.graphics.asSkiaBitmap
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import robotran.world.SessionState
import robotran.world.World

/** The picture of [renderSheet] as the bytes of a PNG file; needs no screen. */
fun sheetPng(world: World, state: SessionState, widthPixels: Int = PICTURE_PIXELS): ByteArray {
    val bitmap = renderSheet(world, state, widthPixels).asSkiaBitmap()
    return Image.makeFromBitmap(bitmap).use { image ->
        checkNotNull(image.encodeToData(EncodedImageFormat.PNG)) { "Skia could not encode the picture" }.bytes
    }
}
