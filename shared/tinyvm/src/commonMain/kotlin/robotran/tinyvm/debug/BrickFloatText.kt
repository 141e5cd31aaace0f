package robotran.tinyvm.debug

/**
 * Formats floats as the brick's class library does, with at most eight digits, such as `2.5` or `1.5E10`. It takes the
 * same steps in 32-bit arithmetic, so the text is the same on every platform and equals what a program shows.
 * Robolang's `decimalText` rounds in 64 bits and differs in the last digits, so the two cannot share code.
 */
internal object BrickFloatText {
    fun of(number: Float): String = when {
        number.isNaN() -> "NaN"
        number < 0f -> "-" + ofSize(-number)
        else -> ofSize(number)
    }

    private fun ofSize(size: Float): String = when {
        size == Float.POSITIVE_INFINITY -> "Infinity"
        size == 0f || (size >= MIN_PLAIN && size < FIRST_WITH_EXPONENT) -> plain(size)
        else -> withExponent(size)
    }

    private fun withExponent(size: Float): String {
        var rest = size
        var exponent = 0
        while (rest >= TEN) {
            val (power, places) = power { rest / it >= TEN }
            rest /= power
            exponent += places
        }
        while (rest < 1f) {
            val (power, places) = power { rest * it < 1f }
            rest *= power
            exponent -= places
        }
        return plain(rest) + "E" + exponent
    }

    /** Returns the smallest power of ten, at most the tenth, for which [tooSmall] is false, and its exponent. */
    private fun power(tooSmall: (Float) -> Boolean): Pair<Float, Int> {
        var power = TEN
        var places = 1
        while (places < HIGHEST_EXACT_POWER && tooSmall(power)) {
            power *= TEN
            places++
        }
        return power to places
    }

    /** Formats [size], below ten million, digit by digit; the zeros before the first digit do not count. */
    private fun plain(size: Float): String {
        val whole = size.toInt()
        val decimals = StringBuilder()
        var digits = if (whole == 0) 0 else whole.toString().length
        var rest = size - whole
        do {
            rest *= TEN
            val digit = rest.toInt()
            rest -= digit
            decimals.append(digit)
            if (digit != 0 || digits > 0) digits++
        } while (rest > 0f && digits < MAX_DIGITS)
        return "$whole." + decimals.trimEnd('0').ifEmpty { "0" }
    }

    private const val MIN_PLAIN = 1.0E-3f
    private const val FIRST_WITH_EXPONENT = 1.0E7f
    private const val TEN = 10f
    private const val MAX_DIGITS = 8
    private const val HIGHEST_EXACT_POWER = 10
}
