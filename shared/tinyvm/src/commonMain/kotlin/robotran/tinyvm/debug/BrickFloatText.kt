package robotran.tinyvm.debug

/**
 * Formats floats as the brick's class library does, with at most seven digits, such as `2.5` or `1.5E10`. It takes the
 * same steps in 32-bit arithmetic, so the text is the same on every platform and equals what a program shows.
 * Robolang's `decimalText` rounds in 64 bits and differs in the last digit for about one number in nine, so the two
 * cannot share code.
 */
internal object BrickFloatText {
    fun of(number: Float): String = when {
        number.isNaN() -> "NaN"
        number < 0f -> "-" + ofSize(-number)
        else -> ofSize(number)
    }

    private fun ofSize(size: Float): String = when {
        size == Float.POSITIVE_INFINITY -> "Infinity"
        size == 0f -> "0.0"
        size >= MIN_PLAIN && size < FIRST_WITH_EXPONENT -> plain(size, moved = 0)
        else -> withExponent(size)
    }

    private fun withExponent(size: Float): String {
        var rest = size
        var exponent = 0
        while (rest >= BILLION) {
            val (power, places) = power { rest / it >= BILLION }
            rest /= power
            exponent += places
        }
        while (rest < 1f) {
            val (power, places) = power { rest * it < 1f }
            rest *= power
            exponent -= places
        }
        val before = wholeFigures(rest) - 1
        return plain(rest, before) + "E" + (exponent + before)
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

    private fun wholeFigures(size: Float): Int {
        var figures = 1
        var bound = TEN
        while (size >= bound) {
            figures++
            bound *= TEN
        }
        return figures
    }

    /** Formats [size] with the decimal point moved [moved] places to the left. */
    private fun plain(size: Float, moved: Int): String {
        var power = 1f
        var decimals = 0
        while (size * power < MILLION) {
            power *= TEN
            decimals++
        }
        val scaled = size * power
        var figures = scaled.toInt()
        if (scaled - figures >= HALF) figures++
        var fraction = decimals + moved
        while (figures >= TEN_MILLION) {
            figures = (figures + 5) / 10
            fraction--
        }
        while (fraction > 1 && figures % 10 == 0) {
            figures /= 10
            fraction--
        }
        return placed(figures.toString(), fraction)
    }

    private fun placed(written: String, fraction: Int): String {
        val whole = written.length - fraction
        val behind = "0".repeat(maxOf(0, -whole)) + written.drop(maxOf(0, whole))
        return written.take(maxOf(0, whole)).ifEmpty { "0" } + "." + behind.ifEmpty { "0" }
    }

    private const val MIN_PLAIN = 1.0E-3f
    private const val FIRST_WITH_EXPONENT = 1.0E7f
    private const val BILLION = 1.0E9f
    private const val MILLION = 1_000_000f
    private const val TEN_MILLION = 10_000_000
    private const val TEN = 10f
    private const val HALF = 0.5f
    private const val HIGHEST_EXACT_POWER = 10
}
