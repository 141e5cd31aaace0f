package robotran.json

/**
 * The value of a JSON number, or null if [text] is not one. Only the first fifteen significant digits count: with
 * those, one multiplication or division by a power of ten gives the nearest double on every target, which the
 * platforms' own functions do not guarantee.
 */
fun readDecimal(text: String): Double? {
    val parts = numberParts(text) ?: return null
    val digits = (parts.whole + parts.fraction).trimStart('0')
    val significant = digits.take(SIGNIFICANT_DIGITS)
    if (significant.isEmpty()) return 0.0
    // A power of ten that overflows an Int is beyond any double anyway.
    val written = if (parts.power.isEmpty()) {
        0
    } else {
        parts.power.removePrefix("+").toIntOrNull()
            ?: if (parts.power[0] == '-') -FAR else FAR
    }
    val exponent = written.coerceIn(-FAR, FAR) - parts.fraction.length + digits.length - significant.length
    val size = when {
        exponent > EXACT_POWER_OF_TEN -> Double.POSITIVE_INFINITY
        exponent >= 0 -> significant.toLong().toDouble() * powerOfTen(exponent)
        exponent >= -EXACT_POWER_OF_TEN -> significant.toLong().toDouble() / powerOfTen(-exponent)
        else -> 0.0
    }
    // There is only one zero, so that results can be compared.
    return if (parts.negative && size != 0.0) -size else size
}

/** Whether [text] is a valid JSON number. */
internal fun isNumber(text: String): Boolean = numberParts(text) != null

private class NumberParts(val negative: Boolean, val whole: String, val fraction: String, val power: String)

private fun numberParts(text: String): NumberParts? {
    val sign = if (text.startsWith('-')) 1 else 0
    val wholeEnd = digitsEnd(text, sign)
    if (wholeEnd == sign || (text[sign] == '0' && wholeEnd > sign + 1)) return null
    val fraction = if (text.getOrNull(wholeEnd) == '.') wholeEnd + 1 else wholeEnd
    val fractionEnd = digitsEnd(text, fraction)
    if (fraction > wholeEnd && fractionEnd == fraction) return null
    val power = if (text.getOrNull(fractionEnd) == 'e' || text.getOrNull(fractionEnd) == 'E') {
        fractionEnd + 1
    } else {
        fractionEnd
    }
    val powerDigits = if (power > fractionEnd && (text.getOrNull(power) == '-' || text.getOrNull(power) == '+')) {
        power + 1
    } else {
        power
    }
    val end = if (power > fractionEnd) digitsEnd(text, powerDigits) else fractionEnd
    if (end != text.length || (power > fractionEnd && end == powerDigits)) return null
    val decimals = if (fraction > wholeEnd) text.substring(fraction, fractionEnd) else ""
    return NumberParts(sign == 1, text.substring(sign, wholeEnd), decimals, text.substring(power))
}

private fun digitsEnd(text: String, from: Int): Int {
    var end = from
    while (end < text.length && text[end] in '0'..'9') end++
    return end
}

internal fun powerOfTen(exponent: Int): Double {
    var power = 1.0
    repeat(exponent) { power *= TEN }
    return power
}

private const val TEN = 10.0
private const val SIGNIFICANT_DIGITS = 15

/** The largest power of ten that a double represents exactly. */
internal const val EXACT_POWER_OF_TEN = 22
private const val FAR = 1_000_000_000
