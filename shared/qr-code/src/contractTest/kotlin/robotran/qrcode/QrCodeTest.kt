package robotran.qrcode

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class QrCodeTest {
    @Test
    fun `a short text fits the smallest code, whose corners are finder patterns`() {
        val code = assertNotNull(QrCode.of("robotran"))
        assertEquals(21, code.size)
        for ((column, row) in listOf(0 to 0, 14 to 0, 0 to 14)) {
            assertTrue(code.isDark(column, row) && code.isDark(column + 6, row + 6) && code.isDark(column + 3, row + 3))
            assertTrue(!code.isDark(column + 1, row + 1) && !code.isDark(column + 5, row + 1))
        }
    }

    @Test
    fun `codes grow with the text up to the longest that they take`() {
        val sizes = listOf(17, 18, 500, QrCode.MAX_BYTES).map { length ->
            assertNotNull(QrCode.of("a".repeat(length))).size
        }
        assertEquals(listOf(21, 25, 77, 117), sizes)
        assertNull(QrCode.of("a".repeat(QrCode.MAX_BYTES + 1)))
    }

    @Test
    fun `letters outside of English count as the bytes that they are written with`() {
        assertNull(QrCode.of("ä".repeat(QrCode.MAX_BYTES / 2 + 1)))
        assertNotNull(QrCode.of("ä".repeat(QrCode.MAX_BYTES / 2)))
    }
}
