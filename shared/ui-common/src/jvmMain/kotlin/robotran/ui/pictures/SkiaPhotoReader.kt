package robotran.ui.pictures

import org.jetbrains.skia.Codec
import org.jetbrains.skia.Color
import org.jetbrains.skia.Data
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.FilterMipmap
import org.jetbrains.skia.FilterMode
import org.jetbrains.skia.Image
import org.jetbrains.skia.MipmapMode
import org.jetbrains.skia.Rect
import org.jetbrains.skia.Surface
import robotran.workshop.platform.Photo
import robotran.workshop.platform.PhotoReader
import kotlin.math.roundToInt

/** Reads photos with Skia. It turns them upright by what the camera wrote into the file. */
object SkiaPhotoReader : PhotoReader {
    override suspend fun read(bytes: ByteArray): Photo? = try {
        if (pixelsIn(bytes) > MAX_PIXELS) null else Image.makeFromEncoded(bytes).use { SkiaPhoto(inMemory(it)) }
    } catch (_: IllegalArgumentException) {
        null
    }

    /** A file of a few bytes could claim a picture that no machine has memory for. */
    private fun pixelsIn(bytes: ByteArray): Long = Data.makeFromBytes(bytes).use { data ->
        Codec.makeFromData(data).use { it.width.toLong() * it.height }
    }

    /** Decoded once, at a size that is enough for any assignment. */
    private fun inMemory(image: Image): Image {
        val scale = minOf(1f, MAX_SIDE / maxOf(image.width, image.height))
        return scaled(image, (image.width * scale).roundToInt(), (image.height * scale).roundToInt())
    }

    private const val MAX_PIXELS = 120_000_000L
    private const val MAX_SIDE = 2400f
}

private class SkiaPhoto(private val image: Image) : Photo {
    override val width: Int get() = image.width
    override val height: Int get() = image.height

    override suspend fun jpeg(width: Int, height: Int, quality: Int): ByteArray =
        scaled(image, width, height).use { smaller ->
            checkNotNull(smaller.encodeToData(EncodedImageFormat.JPEG, quality)) { "Skia could not encode it" }
                .use { it.bytes }
        }

    override fun close() = image.close()
}

private fun scaled(image: Image, width: Int, height: Int): Image =
    Surface.makeRasterN32Premul(width.coerceAtLeast(1), height.coerceAtLeast(1)).use { surface ->
        surface.canvas.clear(Color.WHITE)
        surface.canvas.drawImageRect(
            image,
            Rect.makeWH(image.width.toFloat(), image.height.toFloat()),
            Rect.makeWH(surface.width.toFloat(), surface.height.toFloat()),
            FilterMipmap(FilterMode.LINEAR, MipmapMode.LINEAR),
            null,
            true,
        )
        surface.makeImageSnapshot()
    }
