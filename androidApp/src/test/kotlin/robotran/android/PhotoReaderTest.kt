package robotran.android

import android.graphics.Bitmap
import android.graphics.BitmapFactory
import android.graphics.Color
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.annotation.GraphicsMode
import robotran.android.platform.AndroidPhotoReader
import java.io.ByteArrayOutputStream

@RunWith(RobolectricTestRunner::class)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
class PhotoReaderTest {
    @Test
    fun `a photo that was taken upright is shown upright, red above and blue below`() = runBlocking {
        // The sensor lies across: what is above is at its left.
        val photo = checkNotNull(AndroidPhotoReader.read(turned(photo(400, 300), ROTATED)))
        assertEquals(300 to 400, photo.width to photo.height)
        val bytes = photo.jpeg(150, 200, 85)
        val smaller = BitmapFactory.decodeByteArray(bytes, 0, bytes.size)
        assertEquals(150 to 200, smaller.width to smaller.height)
        assertTrue("The upper end is not red.", Color.red(smaller.getPixel(75, 10)) > 200)
        assertTrue("The lower end is not blue.", Color.blue(smaller.getPixel(75, 190)) > 200)
    }

    @Test
    fun `what is no picture is not read`() = runBlocking {
        assertNull(AndroidPhotoReader.read("not a picture".encodeToByteArray()))
    }

    private fun photo(width: Int, height: Int): ByteArray {
        val picture = Bitmap.createBitmap(width, height, Bitmap.Config.ARGB_8888)
        for (x in 0..<width) for (y in 0..<height) picture.setPixel(x, y, if (x < width / 2) Color.RED else Color.BLUE)
        return ByteArrayOutputStream().also { picture.compress(Bitmap.CompressFormat.JPEG, 95, it) }.toByteArray()
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
