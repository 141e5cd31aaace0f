package robotran.workshop.assignment

import kotlinx.coroutines.runBlocking
import robotran.workshop.platform.NoPhotoReader
import robotran.workshop.platform.Photo
import robotran.workshop.platform.PhotoReader
import robotran.workshop.state.PictureError
import robotran.workshop.state.PictureSize
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class FittedPictureTest {
    @Test
    fun `a photo of a phone is made as much smaller as it must be`() = runBlocking {
        val fitted = assertIs<FittedPicture.Success>(fitPicture(ofPhone, FakeReader(4_000, 3_000, bytesPerPixel = 0.2)))
        assertEquals(PictureSize(1_000, 750), fitted.madeSmaller)
        assertTrue(fitted.bytes.size in 100_000..150_000)
    }

    @Test
    fun `it loses quality before it loses pixels`() = runBlocking {
        val reader = FakeReader(3_000, 4_000, bytesPerPixel = 0.082)
        assertEquals(PictureSize(1_200, 1_600), (fitPicture(ofPhone, reader) as FittedPicture.Success).madeSmaller)
        assertEquals(listOf(85, 75), reader.qualities)
    }

    @Test
    fun `a small picture with a large file keeps its pixels`() = runBlocking {
        val fitted = fitPicture(ofPhone, FakeReader(500, 400, bytesPerPixel = 0.3))
        assertEquals(PictureSize(500, 400), assertIs<FittedPicture.Success>(fitted).madeSmaller)
    }

    @Test
    fun `a photo that cannot be read is told by its kind`() = runBlocking {
        val heic = ByteArray(4) + "ftypheic".encodeToByteArray() + ByteArray(300_000)
        assertEquals(FittedPicture.Failure(PictureError.HEIC), fitPicture(heic, NoPhotoReader))
        val text = "ftyp".encodeToByteArray()
        assertEquals(FittedPicture.Failure(PictureError.NOT_A_PICTURE), fitPicture(text, NoPhotoReader))
        assertEquals(FittedPicture.Failure(PictureError.TOO_LARGE), fitPicture(ofPhone, NoPhotoReader))
    }

    /** The beginning of a JPEG picture of 3 by 2 pixels, in a file of 4 MB. */
    private val ofPhone =
        byteArrayOf(-1, -40, -1, -32, 0, 4, 0, 0, -1, -64, 0, 11, 8, 0, 2, 0, 3, 1) + ByteArray(4_000_000)

    /** Reads a photo whose files need [bytesPerPixel] at the best quality, and a tenth less at the other. */
    private class FakeReader(private val wide: Int, private val high: Int, private val bytesPerPixel: Double) :
        PhotoReader {
        val qualities = mutableListOf<Int>()

        override suspend fun read(bytes: ByteArray): Photo = object : Photo {
            override val width = wide
            override val height = high

            override suspend fun jpeg(width: Int, height: Int, quality: Int): ByteArray {
                qualities += quality
                return ByteArray((width * height * bytesPerPixel * if (quality == 85) 1.0 else 0.9).toInt())
            }

            override fun close() = Unit
        }
    }
}
