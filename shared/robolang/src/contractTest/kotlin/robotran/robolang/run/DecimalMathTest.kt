package robotran.robolang.run

import kotlin.test.Test
import kotlin.test.assertEquals

/** Compares exact bits, which must be the same on every target. */
class DecimalMathTest {
    @Test
    fun `quarters of a turn are exact`() {
        assertEquals(listOf(0f, 1f, 0f, -1f, 0f), listOf(0f, 90f, 180f, 270f, 360f).map { DecimalMath.sine(it) + 0f })
        assertEquals(listOf(1f, 0f, -1f, 0f, 1f), listOf(0f, 90f, 180f, 270f, 360f).map { DecimalMath.cosine(it) + 0f })
        assertEquals(
            listOf(0f, 90f, 180f, -90f),
            listOf(0f to 1f, 1f to 0f, 0f to -1f, -1f to 0f).map { (y, x) ->
                DecimalMath.direction(y, x)
            },
        )
    }

    @Test
    fun `every target gives the same bits`() {
        var hash = 0
        for (step in 0..2_000) {
            val value = step * 0.37f - 370f
            val results = listOf(
                DecimalMath.sine(value),
                DecimalMath.cosine(value),
                DecimalMath.tangent(value),
                DecimalMath.direction(value, 100f),
                DecimalMath.power(step + 0.5f, 0.7f),
                DecimalMath.power(
                    1.1f,
                    value / 10f,
                ),
            )
            for (result in results) hash = hash * 31 + result.toRawBits()
        }
        assertEquals(EXPECTED_HASH, hash)
    }

    @Test
    fun `an angle too large to know its degrees counts as none`() {
        assertEquals(0f, DecimalMath.sine(1e20f))
        assertEquals(1f, DecimalMath.cosine(Float.POSITIVE_INFINITY))
    }

    @Test
    fun `powers of whole numbers are exact`() {
        assertEquals(1024f, DecimalMath.power(2f, 10f))
        assertEquals(-27f, DecimalMath.power(-3f, 3f))
        assertEquals(0.25f, DecimalMath.power(2f, -2f))
        assertEquals(1f, DecimalMath.power(0f, 0f))
        assertEquals(0f, DecimalMath.power(0f, 0.5f))
    }

    @Test
    fun `the texts of decimal numbers are those of a program`() {
        val texts = mapOf(
            0f to "0.0",
            1f to "1.0",
            -2.5f to "-2.5",
            0.1f to "0.1",
            3.14159f to "3.14159",
            1234567f to "1234567.0",
            1e10f to "1.0E10",
            -1.5e-5f to "-1.5E-5",
            Float.NaN to "NaN",
            Float.NEGATIVE_INFINITY to "-Infinity",
            100f to "100.0",
            0.001f to "0.001",
        )
        for ((value, text) in texts) assertEquals(text, decimalText(value))
    }

    @Test
    fun `chance is that of leJOS`() {
        val random = LejosRandom(seed = 0)
        assertEquals(listOf(1, 48271, -1964877856), List(3) { random.next() })
        val dice = LejosRandom(seed = 150)
        assertEquals((1..6).toSet(), List(200) { dice.between(6, 1) }.toSet())
        assertEquals(true, List(200) { dice.between(-1f, 2.5f) }.all { it >= -1f && it <= 2.5f })
    }

    private companion object {
        const val EXPECTED_HASH = 1828562291
    }
}
