package robotran.tinyvm

import robotran.tinyvm.debug.NxtDecimalText
import kotlin.test.Test
import kotlin.test.assertEquals

class NxtDecimalTextTest {
    @Test
    fun `a double is written with at most 15 digits, as leJOS NXJ does`() {
        val written = mapOf(
            0.1 to "0.1",
            -0.0 to "-0.0",
            0.0 to "0.0",
            1.0 to "1.0",
            -100.0 to "-100.0",
            1234567.0 to "1234567.0",
            1.0E7 to "1.0E7",
            0.001 to "0.001",
            9.999E-4 to "9.999E-4",
            0.1 + 0.2 to "0.3",
            1 / 3.0 to "0.333333333333333",
            -2 / 3.0 to "-0.666666666666667",
            2e-3 to "0.002",
            1.7976931348623157E308 to "1.79769313486232E308",
            2.0E23 to "2.0E23",
            9.007199254740992E15 to "9.00719925474099E15",
            5e-324 to "4.94065645841247E-324",
            Double.NaN to "NaN",
            Double.NEGATIVE_INFINITY to "-Infinity",
        )
        for ((number, text) in written) assertEquals(text, NxtDecimalText.of(number))
    }

    @Test
    fun `a float is written with at most 7 digits, the last of which may be one too high`() {
        val written = mapOf(
            0.1f to "0.1",
            -0f to "-0.0",
            1f / 3 to "0.3333334",
            16777216f to "1.677722E7",
            123456.7f to "123456.7",
            1234567f to "1.234567E6",
            9999999f to "1.0E7",
            -0.001f to "-0.001",
            1.4E-45f to "1.401299E-45",
            Float.MAX_VALUE to "3.402823E38",
            Float.POSITIVE_INFINITY to "Infinity",
        )
        for ((number, text) in written) assertEquals(text, NxtDecimalText.of(number))
    }
}
