package robotran.language

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class TextEncodingTest {
    private val words = "// f\u00FCr Mar\u00EDa \u20AC\r\nforward 10\r\n"

    private fun utf16(text: String, isLittle: Boolean): ByteArray = text.flatMap {
        val bytes = listOf(it.code / 0x100, it.code % 0x100)
        if (isLittle) bytes.reversed() else bytes
    }.map { it.toByte() }.toByteArray()

    private fun assertReads(encoding: TextEncoding, bytes: ByteArray, text: String = words) {
        val decoded = assertNotNull(decodeText(bytes))
        assertEquals(text, decoded.text)
        assertEquals(encoding, decoded.encoding)
    }

    @Test
    fun `UTF-8 is read with and without its mark`() {
        assertReads(TextEncoding.UTF_8, words.encodeToByteArray())
        assertReads(TextEncoding.UTF_8, "\uFEFF$words".encodeToByteArray())
        assertReads(TextEncoding.UTF_8, ByteArray(0), "")
    }

    @Test
    fun `UTF-16 is read with either byte first, with its mark and without`() {
        for (isLittle in listOf(true, false)) {
            assertReads(TextEncoding.UTF_16, utf16("\uFEFF$words", isLittle))
            assertReads(TextEncoding.UTF_16, utf16(words, isLittle))
            assertReads(TextEncoding.UTF_16, utf16("\uFEFF\u4F60\uD83D\uDE00", isLittle), "\u4F60\uD83D\uDE00")
            assertReads(TextEncoding.UTF_16, utf16("\uFEFF", isLittle), "")
        }
    }

    @Test
    fun `what is no UTF-8 is in the encoding of Windows`() {
        val codes = mapOf('\u20AC' to 0x80)
        assertReads(TextEncoding.WINDOWS_1252, words.map { (codes[it] ?: it.code).toByte() }.toByteArray())
    }

    @Test
    fun `other files are no texts`() {
        val png = byteArrayOf(0x89.toByte(), 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0, 0, 0, 0x0D)
        assertNull(decodeText(png))
        assertNull(decodeText(byteArrayOf(-1, -2, 0x41)), "half a character")
        assertNull(decodeText(utf16("\uFEFFa\uD800b", isLittle = true)), "an unpaired surrogate")
        assertNull(decodeText(utf16("\uFEFFa\u0001b", isLittle = false)), "a control character")
        assertNull(decodeText(byteArrayOf(-1, -2, 0, 0, 0x41, 0, 0, 0)), "UTF-32")
    }
}
