package robotran.tinyvm.debug

/**
 * Formats decimals as the class library of leJOS NXJ does, with at most 15 digits of a `Double` and 7 of a `Float`. It
 * takes the same steps as the library, so a text equals what a program prints, on every platform.
 */
internal object NxtDecimalText {
    fun of(number: Double): String {
        val isNegative = number.toRawBits() < 0
        val size = if (isNegative) -number else number
        if (!(size > 0 && size < Double.POSITIVE_INFINITY)) return special(number, isNegative)
        val lacksBits = size < SMALLEST_NORMAL
        val power = if (lacksBits) powerOf2(size * TO_NORMAL) - TO_NORMAL_POWER else powerOf2(size)
        var exponent = (power * LOGARITHM_OF_2 - MARGIN) shr LOGARITHM_BITS
        val scaled = scaled(size, DIGITS - 1 - exponent)
        var digits = (scaled + ONE_HALF).toLong()
        if (digits >= DIGITS_LIMIT) {
            exponent++
            digits = (scaled * ONE_TENTH + ONE_HALF).toLong()
        }
        return text(isNegative, digits.toString(), exponent, FIRST_EXPONENT)
    }

    fun of(number: Float): String {
        val isNegative = number.toRawBits() < 0
        val size = if (isNegative) -number else number
        if (!(size > 0 && size < Float.POSITIVE_INFINITY)) return special(number.toDouble(), isNegative)
        val lacksBits = size < SMALLEST_NORMAL_FLOAT
        val power = if (lacksBits) powerOf2(size * TO_NORMAL_FLOAT) - TO_NORMAL_FLOAT_POWER else powerOf2(size)
        var exponent = (power * FLOAT_LOGARITHM_OF_2 - FLOAT_MARGIN) shr FLOAT_LOGARITHM_BITS
        val scaled = scaled(size, FLOAT_DIGITS - 1 - exponent)
        var digits = (scaled + ONE_HALF.toFloat()).toInt()
        if (digits >= FLOAT_DIGITS_LIMIT) {
            exponent++
            digits = (scaled * FLOAT_DOWN[0] + ONE_HALF.toFloat()).toInt()
        }
        return text(isNegative, digits.toString(), exponent, FIRST_FLOAT_EXPONENT)
    }

    private fun special(number: Double, isNegative: Boolean): String = when {
        number.isNaN() -> "NaN"
        number == 0.0 -> if (isNegative) "-0.0" else "0.0"
        else -> if (isNegative) "-Infinity" else "Infinity"
    }

    private fun powerOf2(number: Double): Int = (number.toRawBits() ushr DOUBLE_FRACTION).toInt() - DOUBLE_BIAS

    private fun powerOf2(number: Float): Int = (number.toRawBits() ushr FLOAT_FRACTION) - FLOAT_BIAS

    /** [number] times 10 to [power], rounded after each of the powers 1, 2, 4, 8 and so on that add up to it. */
    private fun scaled(number: Double, power: Int): Double {
        val factors = if (power < 0) DOWN else UP
        return factors.indices.reversed().fold(number) { product, bit ->
            if ((maxOf(power, -power) shr bit) and 1 != 0) product * factors[bit] else product
        }
    }

    private fun scaled(number: Float, power: Int): Float {
        val factors = if (power < 0) FLOAT_DOWN else FLOAT_UP
        return factors.indices.reversed().fold(number) { product, bit ->
            if ((maxOf(power, -power) shr bit) and 1 != 0) product * factors[bit] else product
        }
    }

    /** The text of a number whose first digit counts 10 to the power of [exponent]. */
    private fun text(isNegative: Boolean, digits: String, exponent: Int, firstExponent: Int): String {
        val hasExponent = exponent >= firstExponent || exponent <= LAST_EXPONENT
        val before = if (hasExponent) 1 else maxOf(exponent + 1, 0)
        val zeros = if (hasExponent) 0 else maxOf(-exponent - 1, 0)
        val decimals = "0".repeat(zeros) + digits.drop(before).trimEnd('0')
        return (if (isNegative) "-" else "") + digits.take(before).ifEmpty { "0" } + "." + decimals.ifEmpty { "0" } +
            if (hasExponent) "E$exponent" else ""
    }

    private const val DIGITS = 15
    private const val DIGITS_LIMIT = 1_000_000_000_000_000L
    private const val FLOAT_DIGITS = 7
    private const val FLOAT_DIGITS_LIMIT = 10_000_000

    /** From here on, numbers have an exponent of 10. */
    private const val FIRST_EXPONENT = 7
    private const val FIRST_FLOAT_EXPONENT = 6

    /** The last exponent of 10 of numbers that have one because they are small. */
    private const val LAST_EXPONENT = -4

    private const val ONE_HALF = 0.5
    private const val ONE_TENTH = 0.1

    // Numbers that lack bits are multiplied by a power of 2 to estimate their exponents.
    private const val SMALLEST_NORMAL = 2.2250738585072014e-308
    private const val SMALLEST_NORMAL_FLOAT = 1.17549435e-38f
    private const val TO_NORMAL_POWER = 62
    private const val TO_NORMAL = 4611686018427387904.0
    private const val TO_NORMAL_FLOAT_POWER = 31
    private const val TO_NORMAL_FLOAT = 2147483648f

    // The logarithm of 2 for 10 as a fixed-point number, and what makes the estimate never too large.
    private const val LOGARITHM_OF_2 = 631305
    private const val MARGIN = 802779
    private const val LOGARITHM_BITS = 21
    private const val FLOAT_LOGARITHM_OF_2 = 5050455
    private const val FLOAT_MARGIN = 7334478
    private const val FLOAT_LOGARITHM_BITS = 24

    private const val DOUBLE_FRACTION = 52
    private const val DOUBLE_BIAS = 1023
    private const val FLOAT_FRACTION = 23
    private const val FLOAT_BIAS = 127

    private val UP = doubleArrayOf(1e1, 1e2, 1e4, 1e8, 1e16, 1e32, 1e64, 1e128, 1e256)
    private val DOWN = doubleArrayOf(1e-1, 1e-2, 1e-4, 1e-8, 1e-16, 1e-32, 1e-64, 1e-128, 1e-256)
    private val FLOAT_UP = floatArrayOf(1e1f, 1e2f, 1e4f, 1e8f, 1e16f, 1e32f)
    private val FLOAT_DOWN = floatArrayOf(1e-1f, 1e-2f, 1e-4f, 1e-8f, 1e-16f, 1e-32f)
}
