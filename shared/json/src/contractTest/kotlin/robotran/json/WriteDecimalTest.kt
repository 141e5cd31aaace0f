package robotran.json

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertTrue

class WriteDecimalTest {
    @Test
    fun `numbers are written as short as they can be read`() {
        val numbers = mapOf(
            0.0 to "0",
            -0.0 to "0",
            1.0 to "1",
            -1.0 to "-1",
            0.1 to "0.1",
            100.5 to "100.5",
            -0.125 to "-0.125",
            33.3333333333333 to "33.3333333333333",
            1e-7 to "0.0000001",
            123456789012345.0 to "123456789012345",
            2e9 to "2000000000",
            999999999999999.0 to "999999999999999",
            1e15 to "1000000000000000",
            1.5e21 to "1500000000000000000000",
        )
        numbers.forEach { (number, text) -> assertEquals(text, writeDecimal(number)) }
    }

    @Test
    fun `what has more than fifteen digits is rounded to fifteen`() {
        assertEquals("0.3", writeDecimal(0.1 + 0.2))
        assertEquals("0.333333333333333", writeDecimal(1.0 / 3))
        assertEquals("66.6666666666667", writeDecimal(200.0 / 3))
        assertEquals(0.3, nearestDecimal(0.1 + 0.2))
    }

    @Test
    fun `what can be read is written so that the same is read again`() {
        val random = Random(2005)
        repeat(20_000) {
            val digits = random.nextLong(1_000_000_000_000_000).toString().take(random.nextInt(1, 16))
            val literal = if (random.nextBoolean()) "${digits.toLong()}e${random.nextInt(-22, 8)}" else "-0.$digits"
            val number = checkNotNull(readDecimal(literal))
            assertEquals(number, readDecimal(writeDecimal(number)), literal)
        }
    }

    @Test
    fun `what was rounded once stays as it is`() {
        val random = Random(2005)
        repeat(20_000) {
            val number = random.nextDouble(-2000.0, 2000.0)
            val rounded = nearestDecimal(number)
            assertEquals(rounded, nearestDecimal(rounded))
            assertTrue(kotlin.math.abs(rounded - number) < 1e-11)
        }
    }

    @Test
    fun `there is no text for what is not finite`() {
        listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY).forEach {
            assertFailsWith<IllegalArgumentException> { writeDecimal(it) }
        }
    }
}
