package robotran.qrcode

import com.google.zxing.BinaryBitmap
import com.google.zxing.DecodeHintType
import com.google.zxing.RGBLuminanceSource
import com.google.zxing.ReaderException
import com.google.zxing.common.HybridBinarizer
import com.google.zxing.qrcode.QRCodeReader
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

/** Reads the codes with another reader, as a phone does. */
class ReadQrCodeTest {
    @Test
    fun `codes of all sizes are read as what they say`() {
        val lengths = (1..<300 step 7) + (300..QrCode.MAX_BYTES step 31)
        val codes = lengths.map { assertNotNull(QrCode.of(linkOf(it))) }
        assertEquals(25, codes.distinctBy { it.size }.size)
        val misread = lengths.zip(codes).filter { (length, code) -> read(code, PURE) != linkOf(length) }
        assertEquals(emptyList(), misread.map { (length, code) -> "$length characters in ${code.size} modules" })
    }

    @Test
    fun `codes of usual links are found in a picture, too`() {
        val lengths = 200..850 step 50
        val misread = lengths.filter { length ->
            read(assertNotNull(QrCode.of(linkOf(length))), SOMEWHERE) != linkOf(length)
        }
        assertEquals(emptyList(), misread)
    }

    @Test
    fun `umlauts and accents come back`() {
        val text = "https://example.org/#Prüfung-año-ß"
        assertEquals(text, read(assertNotNull(QrCode.of(text)), PURE))
    }

    /** A text like a link, different at every position. */
    private fun linkOf(length: Int): String {
        val signs = ('a'..'z') + ('A'..'Z') + ('0'..'9') + listOf('-', '_')
        val noise = List(length) { signs[(it * it * 31 + it * 7 + length) % signs.size] }.joinToString("")
        return "https://example.org/#p=a$noise".take(length)
    }

    /** The reader's result for [code] with [hint]; the failure if it cannot read it. */
    private fun read(code: QrCode, hint: DecodeHintType): String {
        val side = (code.size + 2 * QrCode.MARGIN) * PIXELS
        val pixels = IntArray(side * side) { place ->
            val column = place % side / PIXELS - QrCode.MARGIN
            val row = place / side / PIXELS - QrCode.MARGIN
            val isInside = column in 0..<code.size && row in 0..<code.size
            if (isInside && code.isDark(column, row)) 0 else 0xFFFFFF
        }
        val picture = BinaryBitmap(HybridBinarizer(RGBLuminanceSource(side, side, pixels)))
        return try {
            QRCodeReader().decode(picture, mapOf(DecodeHintType.CHARACTER_SET to "UTF-8", hint to true)).text
        } catch (failure: ReaderException) {
            failure.toString()
        }
    }

    private companion object {
        const val PIXELS = 4
        val PURE = DecodeHintType.PURE_BARCODE
        val SOMEWHERE = DecodeHintType.TRY_HARDER
    }
}
