package robotran.robolang.run

/**
 * Functions of decimal numbers computed only with 32-bit additions, multiplications and divisions, so that every target
 * and a translated program give the same bits. Angles are in degrees.
 *
 * For angles up to 100,000 degrees, sine and cosine are accurate to 3e-7; `atan2` is accurate to 3e-5 degrees. The
 * relative error of [power] is at most 2e-5 for results between 1e-9 and 1e9.
 */
internal object DecimalMath {
    private const val RADIANS_PER_DEGREE = 0.017453292f
    private const val DEGREES_PER_RADIAN = 57.29578f
    private const val QUARTER_TURN = 90f

    /** The max angle; a larger 32-bit float does not resolve single degrees. */
    private const val LARGEST_ANGLE = 16777216f

    private const val TANGENT_OF_EIGHTH = 0.41421357f
    private const val NATURAL_LOGARITHM_OF_2 = 0.6931472f
    private const val ROOT_OF_2 = 1.4142135f

    /** The range of binary exponents of 32-bit floats, including denormal ones, with a margin. */
    private const val LARGEST_BINARY_EXPONENT = 160f

    fun sine(degrees: Float): Float {
        if (!isTurn(degrees)) return 0f
        val quarters = roundToWhole(degrees / QUARTER_TURN)
        val rest = (degrees - quarters * QUARTER_TURN) * RADIANS_PER_DEGREE
        return when (quarters and 3) {
            0 -> sineOfSmall(rest)
            1 -> cosineOfSmall(rest)
            2 -> -sineOfSmall(rest)
            else -> -cosineOfSmall(rest)
        }
    }

    fun cosine(degrees: Float): Float {
        if (!isTurn(degrees)) return 1f
        val quarters = roundToWhole(degrees / QUARTER_TURN)
        val rest = (degrees - quarters * QUARTER_TURN) * RADIANS_PER_DEGREE
        return when (quarters and 3) {
            0 -> cosineOfSmall(rest)
            1 -> -sineOfSmall(rest)
            2 -> -cosineOfSmall(rest)
            else -> sineOfSmall(rest)
        }
    }

    /** Infinite where the cosine is 0. */
    fun tangent(degrees: Float): Float = sine(degrees) / cosine(degrees)

    /** The direction of the point [x] to the right and [y] up, from -180 to 180; 0 for the origin. */
    fun direction(y: Float, x: Float): Float {
        val right = if (x < 0f) -x else x
        val up = if (y < 0f) -y else y
        val angle = when {
            right == 0f && up == 0f -> 0f
            up <= right -> arcOf(up / right)
            else -> QUARTER_TURN - arcOf(right / up)
        }
        val upper = if (x < 0f) 2 * QUARTER_TURN - angle else angle
        return if (y < 0f) -upper else upper
    }

    /** [base] to the power of [exponent]; NaN for a negative base with a fractional exponent. */
    fun power(base: Float, exponent: Float): Float {
        val whole = exponent.toInt()
        return when {
            whole.toFloat() == exponent -> wholePower(base, whole)
            base == 0f -> if (exponent > 0f) 0f else 1f / base
            else -> powerOfTwo(exponent * logarithmToBase2(base))
        }
    }

    private fun isTurn(degrees: Float): Boolean = degrees > -LARGEST_ANGLE && degrees < LARGEST_ANGLE

    /** A Taylor series for angles up to an eighth of a turn, in radians. */
    private fun sineOfSmall(x: Float): Float {
        val square = x * x
        return x * (1f - square / 6f * (1f - square / 20f * (1f - square / 42f * (1f - square / 72f))))
    }

    private fun cosineOfSmall(x: Float): Float {
        val square = x * x
        return 1f - square / 2f * (1f - square / 12f * (1f - square / 30f * (1f - square / 56f)))
    }

    /** The arc tangent in degrees of [tangent], 0..1. */
    private fun arcOf(tangent: Float): Float = if (tangent > TANGENT_OF_EIGHTH) {
        QUARTER_TURN / 2 + smallArcOf((tangent - 1f) / (tangent + 1f))
    } else {
        smallArcOf(tangent)
    }

    private fun smallArcOf(t: Float): Float {
        val square = t * t
        var sum = 0f
        for (divisor in 15 downTo 1 step 2) sum = 1f / divisor - square * sum
        return t * sum * DEGREES_PER_RADIAN
    }

    private fun wholePower(base: Float, exponent: Int): Float {
        var factor = base
        var rest = exponent.toLong().let { if (it < 0) -it else it }
        var product = 1f
        while (rest > 0) {
            if (rest and 1L == 1L) product *= factor
            factor *= factor
            rest = rest shr 1
        }
        return if (exponent < 0) 1f / product else product
    }

    private fun logarithmToBase2(value: Float): Float {
        if (value > Float.MAX_VALUE || value != value) return value
        var mantissa = value
        var exponent = 0
        while (mantissa > ROOT_OF_2) {
            mantissa /= 2f
            exponent++
        }
        while (mantissa < ROOT_OF_2 / 2f) {
            mantissa *= 2f
            exponent--
        }
        val s = (mantissa - 1f) / (mantissa + 1f)
        val square = s * s
        var sum = 0f
        for (divisor in 9 downTo 1 step 2) sum = 1f / divisor + square * sum
        return exponent + 2f * s * sum / NATURAL_LOGARITHM_OF_2
    }

    private fun powerOfTwo(exponent: Float): Float {
        if (exponent != exponent) return exponent
        val limited = exponent.coerceIn(-LARGEST_BINARY_EXPONENT, LARGEST_BINARY_EXPONENT)
        val whole = roundToWhole(limited)
        val x = (limited - whole) * NATURAL_LOGARITHM_OF_2
        var result = 1f
        for (divisor in 7 downTo 1) result = 1f + x / divisor * result
        repeat(if (whole < 0) -whole else whole) { result = if (whole < 0) result / 2f else result * 2f }
        return result
    }
}
