package robotran.json

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class ReadDecimalTest {
    @Test
    fun `decimal numbers are read to the nearest double`() {
        assertEquals(0.1, readDecimal("0.1"))
        assertEquals(-32.5, readDecimal("-32.5"))
        assertEquals(1e-7, readDecimal("0.0000001"))
        assertEquals(123456789.012345, readDecimal("123456789.012345"))
        assertEquals(2.5e21, readDecimal("25E+20"))
        assertEquals(0.0, readDecimal("0.000"))
    }

    @Test
    fun `digits after the fifteenth do not count`() {
        assertEquals(33.3333333333333, readDecimal("33.333333333333339"))
        assertEquals(1.23456789012345e19, readDecimal("12345678901234567890"))
    }

    @Test
    fun `numbers too large or too small to matter become infinite or zero`() {
        assertEquals(Double.POSITIVE_INFINITY, readDecimal("1e99999999999"))
        assertEquals(Double.NEGATIVE_INFINITY, readDecimal("-1e400"))
        assertEquals(0.0, readDecimal("1e-99999999999"))
    }

    @Test
    fun `what JSON does not call a number is none`() {
        listOf("", "-", "NaN", "Infinity", "0x10", "1.", ".5", "01", "1e", "1 ", "١").forEach {
            assertNull(readDecimal(it), it)
        }
    }
}
