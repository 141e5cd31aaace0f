package robotran.workshop.platform

import com.google.zxing.BarcodeFormat
import com.google.zxing.qrcode.QRCodeWriter
import kotlinx.coroutines.test.runTest
import robotran.workshop.documents.MemoryFilePicker
import robotran.workshop.state.QrScannerKind
import kotlin.coroutines.EmptyCoroutineContext
import kotlin.test.Test
import kotlin.test.assertEquals

class PictureQrScannerTest {
    private val files = MemoryFilePicker()
    private val words = QrScannerWords("", "", "", "", "", "")

    /** Pictures are named by what is in them. */
    private val pictures = mapOf(
        1 to picture("https://school.example/#h=first", "https://school.example/#h=second"),
        2 to picture("https://school.example/#h=second", "something else"),
        3 to picture(),
        4 to null,
    )
    private val scanner = PictureQrScanner(files, EmptyCoroutineContext) { pictures[it.single().toInt()] }

    private fun withCamera(photo: PhotoResult, isThere: Boolean = true) = PictureQrScanner(
        files,
        EmptyCoroutineContext,
        object : PhotoTaker {
            override val isThere = isThere

            override suspend fun take() = photo
        },
    ) { pictures[it.single().toInt()] }

    /** Codes for [texts] side by side. */
    private fun picture(vararg texts: String): Pixels {
        val codes = texts.map { QRCodeWriter().encode(it, BarcodeFormat.QR_CODE, SIDE, SIDE) }
        val width = SIDE * maxOf(1, codes.size)
        return Pixels(
            width,
            SIDE,
            IntArray(width * SIDE) { place ->
                val (x, y) = place % width to place / width
                if (codes.getOrNull(x / SIDE)?.get(x % SIDE, y) == true) 0 else 0xFFFFFF
            },
        )
    }

    private fun choose(vararg numbers: Int) {
        files.chosen = numbers.map { OpenedFile("$it.png", byteArrayOf(it.toByte())) }
    }

    @Test
    fun `all codes in all pictures are found, each once`() = runTest {
        choose(1, 4, 2)
        val found = mutableListOf<String>()
        assertEquals(QrScanResult.Ended, scanner.scan(QrScannerKind.PICTURES, words, found::add))
        assertEquals(
            listOf("https://school.example/#h=first", "https://school.example/#h=second", "something else"),
            found.sorted(),
        )
    }

    @Test
    fun `pictures without codes are told`() = runTest {
        choose(3, 4)
        assertEquals(QrScanResult.NoCodes, scanner.scan(QrScannerKind.PICTURES, words) { error(it) })
    }

    @Test
    fun `nothing is chosen`() = runTest {
        choose()
        assertEquals(QrScanResult.Ended, scanner.scan(QrScannerKind.PICTURES, words) { error(it) })
    }

    @Test
    fun `a picture that is taken is read like one that is chosen`() = runTest {
        val camera = withCamera(PhotoResult.Taken(byteArrayOf(1)))
        assertEquals(listOf(QrScannerKind.PHOTO, QrScannerKind.PICTURES), camera.kinds)
        val found = mutableListOf<String>()
        assertEquals(QrScanResult.Ended, camera.scan(QrScannerKind.PHOTO, words, found::add))
        assertEquals(2, found.size)
        choose(3)
        assertEquals(QrScanResult.NoCodes, camera.scan(QrScannerKind.PICTURES, words) { error(it) })
    }

    @Test
    fun `a picture that is not taken is no fault, and without a camera only pictures are offered`() = runTest {
        val photos = listOf(PhotoResult.Cancelled, PhotoResult.NoCamera, PhotoResult.Taken(byteArrayOf(3)))
        val results = photos.map { photo ->
            withCamera(photo).scan(QrScannerKind.PHOTO, words) { error(it) }
        }
        assertEquals(listOf(QrScanResult.Ended, QrScanResult.NoCamera, QrScanResult.NoCodes), results)
        assertEquals(listOf(QrScannerKind.PICTURES), withCamera(PhotoResult.Cancelled, isThere = false).kinds)
        assertEquals(listOf(QrScannerKind.PICTURES), scanner.kinds)
    }

    private companion object {
        const val SIDE = 200
    }
}
