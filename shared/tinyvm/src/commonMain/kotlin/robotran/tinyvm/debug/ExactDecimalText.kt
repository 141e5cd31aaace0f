package robotran.tinyvm.debug

/**
 * Formats decimals as the class library of leJOS NXJ does: with the fewest digits from which the same number can be read.
 * It calculates with whole numbers only, because platforms differ in how they write decimals.
 */
internal object ExactDecimalText {
    fun of(number: Double): String {
        val bits = number.toRawBits()
        val exponent = (bits ushr DOUBLE_FRACTION).toInt() and DOUBLE_EXPONENTS
        val fraction = bits and ((1L shl DOUBLE_FRACTION) - 1)
        return of(number < 0 || (number == 0.0 && bits < 0), number, exponent, fraction, DOUBLE_FRACTION, DOUBLE_BIAS)
    }

    fun of(number: Float): String {
        val bits = number.toRawBits()
        val exponent = (bits ushr FLOAT_FRACTION) and FLOAT_EXPONENTS
        val fraction = (bits and ((1 shl FLOAT_FRACTION) - 1)).toLong()
        val isNegative = number < 0 || (number == 0f && bits < 0)
        return of(isNegative, number.toDouble(), exponent, fraction, FLOAT_FRACTION, FLOAT_BIAS)
    }

    private fun of(isNegative: Boolean, number: Double, exponent: Int, fraction: Long, bits: Int, bias: Int): String {
        val sign = if (isNegative) "-" else ""
        return when {
            number.isNaN() -> {
                "NaN"
            }

            number.isInfinite() -> {
                sign + "Infinity"
            }

            number == 0.0 -> {
                sign + "0.0"
            }

            else -> {
                val (digits, point) = digits(fraction, exponent, bits, bias)
                sign + layout(digits, point)
            }
        }
    }

    /** The shortest digits of a positive number, and how many of them stand before the point. */
    private fun digits(fraction: Long, exponent: Int, bits: Int, bias: Int): Pair<String, Int> {
        val whole = if (exponent == 0) fraction else fraction or (1L shl bits)
        val power = maxOf(exponent, 1) - bias - bits
        // The next smaller number is nearer if this one is a power of two.
        val isPowerOfTwo = fraction == 0L && exponent > 1
        val rest = NaturalNumber(whole)
        val unit = NaturalNumber(1)
        val above = NaturalNumber(1)
        rest.double(maxOf(power, 0) + if (isPowerOfTwo) 2 else 1)
        unit.double(maxOf(-power, 0) + if (isPowerOfTwo) 2 else 1)
        above.double(maxOf(power, 0) + if (isPowerOfTwo) 1 else 0)
        val below = NaturalNumber(1).also { it.double(maxOf(power, 0)) }
        val includesEnds = whole % 2 == 0L
        var point = 0
        while (isAtLeast(sum(rest, above), unit, includesEnds)) {
            unit.multiply(TEN)
            point++
        }
        while (!isAtLeast(sum(rest, above).also { it.multiply(TEN) }, unit, includesEnds)) {
            listOf(rest, above, below).forEach { it.multiply(TEN) }
            point--
        }
        return generate(rest, unit, above, below, includesEnds) to point
    }

    private fun generate(
        rest: NaturalNumber,
        unit: NaturalNumber,
        above: NaturalNumber,
        below: NaturalNumber,
        includesEnds: Boolean,
    ): String {
        val digits = StringBuilder()
        while (true) {
            listOf(rest, above, below).forEach { it.multiply(TEN) }
            var digit = 0
            while (rest >= unit) {
                rest.subtract(unit)
                digit++
            }
            val isLow = isAtLeast(below, rest, includesEnds)
            val isHigh = isAtLeast(sum(rest, above), unit, includesEnds)
            if (!isLow && !isHigh) {
                digits.append(digit)
                continue
            }
            val isUp = isHigh && (!isLow || sum(rest, rest) >= unit)
            return digits.append(if (isUp) digit + 1 else digit).toString()
        }
    }

    private fun isAtLeast(left: NaturalNumber, right: NaturalNumber, orEqual: Boolean): Boolean =
        if (orEqual) left >= right else left > right

    private fun sum(left: NaturalNumber, right: NaturalNumber): NaturalNumber = left.copy().also { it.add(right) }

    private fun layout(digits: String, point: Int): String = when (point) {
        in FIRST_PLAIN..0 -> {
            "0." + "0".repeat(-point) + digits
        }

        in 1..LAST_PLAIN -> {
            val padded = digits.padEnd(point, '0')
            padded.take(point) + "." + padded.drop(point).ifEmpty { "0" }
        }

        else -> {
            digits.take(1) + "." + digits.drop(1).ifEmpty { "0" } + "E" + (point - 1)
        }
    }

    private const val TEN = 10
    private const val DOUBLE_FRACTION = 52
    private const val DOUBLE_EXPONENTS = 0x7FF
    private const val DOUBLE_BIAS = 1023
    private const val FLOAT_FRACTION = 23
    private const val FLOAT_EXPONENTS = 0xFF
    private const val FLOAT_BIAS = 127

    /** From a thousandth to ten million, there is no exponent. */
    private const val FIRST_PLAIN = -2
    private const val LAST_PLAIN = 7
}
