package robotran.tinyvm.run

private const val EXPONENT_SHIFT = 52
private const val FRACTION_MASK = 0xFFFFFFFFFFFFFL
private const val HIDDEN_BIT = 0x10000000000000L

/**
 * The remainder of [dividend] as in the Java language: exact, with the sign of the dividend. It is computed with whole
 * numbers, since platforms differ in theirs.
 */
internal fun remainder(dividend: Double, divisor: Double): Double {
    val isUndefined = dividend.isNaN() || divisor.isNaN() || dividend.isInfinite() || divisor == 0.0
    if (isUndefined) return Double.NaN
    val sign = dividend.toRawBits() and Long.MIN_VALUE
    val size = dividend.toRawBits() and Long.MAX_VALUE
    val divisorSize = divisor.toRawBits() and Long.MAX_VALUE
    if (size < divisorSize) return dividend
    val last = exponentOf(divisorSize)
    val subtracted = digitsOf(divisorSize)
    var exponent = exponentOf(size)
    var rest = digitsOf(size)
    while (true) {
        if (rest >= subtracted) rest -= subtracted
        if (exponent == last || rest == 0L) break
        rest = rest shl 1
        exponent--
    }
    if (rest == 0L) return Double.fromBits(sign)
    val missing = rest.countLeadingZeroBits() - HIDDEN_BIT.countLeadingZeroBits()
    rest = rest shl missing
    exponent -= missing
    val bits = if (exponent > 0) {
        (rest and FRACTION_MASK) or (exponent.toLong() shl EXPONENT_SHIFT)
    } else {
        rest ushr (1 - exponent)
    }
    return Double.fromBits(bits or sign)
}

/** The exponent of the positive number with these [bits], so that [digitsOf] has 53 digits; it may be below 1. */
private fun exponentOf(bits: Long): Int {
    val exponent = (bits ushr EXPONENT_SHIFT).toInt()
    return if (exponent > 0) exponent else 1 - missingDigits(bits)
}

/** The 53 binary digits of the positive number with these [bits]. */
private fun digitsOf(bits: Long): Long {
    val isNormal = bits ushr EXPONENT_SHIFT > 0
    return if (isNormal) (bits and FRACTION_MASK) or HIDDEN_BIT else bits shl missingDigits(bits)
}

private fun missingDigits(bits: Long): Int = bits.countLeadingZeroBits() - HIDDEN_BIT.countLeadingZeroBits()
