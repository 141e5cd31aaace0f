package robotran.robolang.syntax

import kotlin.test.Test
import kotlin.test.assertEquals

class NumberReadingTest {
    @Test
    fun `whole numbers go to the limits of 32 bits`() {
        assertEquals(NumberReading.Read(NumberValue.Whole(Int.MAX_VALUE)), readNumber("2147483647", negative = false))
        assertEquals(NumberReading.Read(NumberValue.Whole(Int.MIN_VALUE)), readNumber("2147483648", negative = true))
        assertEquals(NumberReading.TooLarge, readNumber("2147483648", negative = false))
        assertEquals(NumberReading.TooLarge, readNumber("9".repeat(1000), negative = true))
    }

    @Test
    fun `a decimal number is the nearest one of 32 bits`() {
        assertEquals(0x3DCCCCCD, bitsOf("0.1"))
        assertEquals(0x3F7FFFFF, bitsOf("0.99999994"))
        assertEquals(0x40490FDB, bitsOf("3.14159265358979323846"))
        assertEquals(0x4F000000, bitsOf("2147483647.999999999999"))
    }

    @Test
    fun `points belong between digits`() {
        assertEquals(NumberReading.Malformed("0.5"), readNumber(".5", negative = false))
        assertEquals(NumberReading.Malformed("5.0"), readNumber("5.", negative = false))
        assertEquals(NumberReading.Malformed(null), readNumber("1..2", negative = false))
    }

    private fun bitsOf(digits: String): Int =
        ((readNumber(digits, negative = false) as NumberReading.Read).value as NumberValue.Decimal).decimal.toRawBits()
}
