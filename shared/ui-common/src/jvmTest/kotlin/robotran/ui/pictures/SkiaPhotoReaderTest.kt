package robotran.ui.pictures

import kotlinx.coroutines.runBlocking
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.Color
import org.jetbrains.skia.EncodedImageFormat
import org.jetbrains.skia.Image
import org.jetbrains.skia.Paint
import org.jetbrains.skia.Rect
import org.jetbrains.skia.Surface
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class SkiaPhotoReaderTest {
    @Test
    fun `a photo that was taken upright is shown upright, red above and blue below`() = runBlocking {
        // The sensor lies across: what is above is at its left.
        val photo = assertNotNull(SkiaPhotoReader.read(turned(photo(400, 300), ROTATED)))
        assertEquals(300 to 400, photo.width to photo.height)
        val smaller = Bitmap.makeFromImage(Image.makeFromEncoded(photo.jpeg(150, 200, 85)))
        photo.close()
        assertEquals(150 to 200, smaller.width to smaller.height)
        assertTrue(Color.getR(smaller.getColor(75, 10)) > 200, "The upper end is not red.")
        assertTrue(Color.getB(smaller.getColor(75, 190)) > 200, "The lower end is not blue.")
    }

    @Test
    fun `what is no picture, or claims to be an endless one, is not read`() = runBlocking {
        assertNull(SkiaPhotoReader.read("not a picture".encodeToByteArray()))
        val endless = photo(4, 4, EncodedImageFormat.PNG).also { bytes -> for (index in 16..23) bytes[index] = 0x7F }
        assertNull(SkiaPhotoReader.read(endless))
    }

    private fun photo(width: Int, height: Int, format: EncodedImageFormat = EncodedImageFormat.JPEG): ByteArray =
        Surface.makeRasterN32Premul(width, height).use { surface ->
            surface.canvas.clear(Color.BLUE)
            surface.canvas.drawRect(Rect.makeWH(width / 2f, height.toFloat()), Paint().apply { color = Color.RED })
            checkNotNull(surface.makeImageSnapshot().encodeToData(format, 95)).bytes
        }

    /** [jpeg] with the orientation that a camera writes into its file. */
    private fun turned(jpeg: ByteArray, orientation: Int): ByteArray {
        val entry = byteArrayOf(1, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation.toByte(), 0, 0)
        val tiff = "MM".encodeToByteArray() + byteArrayOf(0, 42, 0, 0, 0, 8, 0, 1) + entry + ByteArray(4)
        val content = "Exif".encodeToByteArray() + ByteArray(2) + tiff
        val head = byteArrayOf(0xFF.toByte(), 0xE1.toByte(), 0, (content.size + 2).toByte())
        return jpeg.copyOf(2) + head + content + jpeg.copyOfRange(2, jpeg.size)
    }

    private companion object {
        /** The sensor's left end is above. */
        const val ROTATED = 6
    }
}
