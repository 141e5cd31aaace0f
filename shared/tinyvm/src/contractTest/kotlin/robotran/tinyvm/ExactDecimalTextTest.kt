package robotran.tinyvm

import robotran.tinyvm.debug.ExactDecimalText
import kotlin.test.Test
import kotlin.test.assertEquals

class ExactDecimalTextTest {
    @Test
    fun `decimals are written as in Java`() {
        val written = mapOf(
            0.1 to "0.1",
            -0.0 to "-0.0",
            1.0 to "1.0",
            100.0 to "100.0",
            1234567.0 to "1234567.0",
            1.0E7 to "1.0E7",
            0.001 to "0.001",
            9.999E-4 to "9.999E-4",
            0.1 + 0.2 to "0.30000000000000004",
            2e-3 to "0.002",
            1.7976931348623157E308 to "1.7976931348623157E308",
            2.0E23 to "2.0E23",
            9.007199254740992E15 to "9.007199254740992E15",
            Double.NaN to "NaN",
            Double.NEGATIVE_INFINITY to "-Infinity",
        )
        for ((number, text) in written) {
            assertEquals(text, ExactDecimalText.of(number))
        }
        assertEquals("0.1", ExactDecimalText.of(0.1f))
        assertEquals("3.4028235E38", ExactDecimalText.of(Float.MAX_VALUE))
        assertEquals("0.33333334", ExactDecimalText.of(1f / 3))
        assertEquals("1.0E-45", ExactDecimalText.of(1.4E-45f))
        assertEquals("5.0E-324", ExactDecimalText.of(5e-324))
    }
}
