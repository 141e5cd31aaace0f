package robotran.tinyvm

import robotran.tinyvm.debug.ExactDecimalText
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** On the JVM, which reads decimals exactly. */
class ExactDecimalReadingTest {
    @Test
    fun `the same number can be read`() {
        val random = Random(5)
        repeat(2_000) {
            val number = Double.fromBits(random.nextLong())
            if (!number.isNaN()) assertEquals(number, ExactDecimalText.of(number).toDouble())
            val digits = ExactDecimalText.of(number).count { it.isDigit() }
            assertTrue(digits <= 17 + 3)
            val short = Float.fromBits(random.nextInt())
            if (!short.isNaN()) assertEquals(short, ExactDecimalText.of(short).toFloat())
        }
    }
}
