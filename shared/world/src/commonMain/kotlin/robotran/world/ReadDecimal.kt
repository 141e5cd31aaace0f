package robotran.world

/**
 * The number that a JSON number literal stands for, or null if [text] is none. Only the first fifteen significant digits count: with
 * those, one multiplication or division by a power of ten gives the nearest double on every target, which the platforms' own
 * functions do not promise.
 */
internal fun readDecimal(text: String): Double? {
    val (sign, whole, fraction, power) = NUMBER.matchEntire(text)?.destructured ?: return null
    val digits = (whole + fraction).trimStart('0')
    val significant = digits.take(SIGNIFICANT_DIGITS)
    if (significant.isEmpty()) return 0.0
    // A power of ten too long for an Int is further out than any double anyway.
    val written = if (power.isEmpty()) 0 else power.removePrefix("+").toIntOrNull() ?: if (power.startsWith('-')) -FAR else FAR
    val exponent = written.coerceIn(-FAR, FAR) - fraction.length + digits.length - significant.length
    val size = when {
        exponent > EXACT_POWER_OF_TEN -> Double.POSITIVE_INFINITY
        exponent >= 0 -> significant.toLong().toDouble() * powerOfTen(exponent)
        exponent >= -EXACT_POWER_OF_TEN -> significant.toLong().toDouble() / powerOfTen(-exponent)
        else -> 0.0
    }
    return if (sign.isEmpty()) size else -size
}

private fun powerOfTen(exponent: Int): Double {
    var power = 1.0
    repeat(exponent) { power *= TEN }
    return power
}

private val NUMBER = Regex("(-?)(0|[1-9][0-9]*)(?:\\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?")
private const val TEN = 10.0
private const val SIGNIFICANT_DIGITS = 15

/** The largest power of ten that a double holds exactly. */
private const val EXACT_POWER_OF_TEN = 22
private const val FAR = 1_000_000_000
