package robotran.robolang.syntax

/** The value of digits and points as the scanner groups them. */
internal sealed interface NumberReading {
    data class Read(val value: NumberValue) : NumberReading

    /** Beyond 32 bits. */
    data object TooLarge : NumberReading

    /** A point is misplaced; [right] is the number that was probably meant. */
    data class Malformed(val right: String?) : NumberReading
}

/**
 * Reads [digits], which contains only digits and points, with a minus sign if [negative]. Uses its own arithmetic,
 * because `toFloat` differs between platforms in the last bit: up to [RobolangLimits.DECIMAL_DIGITS] digits form a
 * whole number that a double holds exactly, so dividing it by a power of ten gives the double nearest to the written
 * number.
 */
internal fun readNumber(digits: String, negative: Boolean): NumberReading {
    val parts = digits.split('.', limit = 3)
    if (parts.size > 2) return NumberReading.Malformed(null)
    val whole = parts[0]
    val fraction = parts.getOrNull(1)
    if (whole.isEmpty() || fraction == "") return NumberReading.Malformed(withDigitsAroundPoint(whole, fraction))
    val wholeValue = wholeValue(whole, negative) ?: return NumberReading.TooLarge
    if (fraction == null) return NumberReading.Read(NumberValue.Whole(wholeValue.toInt()))
    val decimal = decimalValue(whole.trimStart('0'), fraction)
    return NumberReading.Read(NumberValue.Decimal(if (negative) -decimal else decimal))
}

private fun withDigitsAroundPoint(whole: String, fraction: String?): String =
    whole.ifEmpty { "0" } + "." + fraction.orEmpty().ifEmpty { "0" }

/** The signed value; null if it does not fit 32 bits. */
private fun wholeValue(digits: String, negative: Boolean): Long? {
    val significant = digits.trimStart('0').ifEmpty { "0" }
    if (significant.length > Int.MAX_VALUE.toString().length) return null
    val value = if (negative) -significant.toLong() else significant.toLong()
    return value.takeIf { it in Int.MIN_VALUE..Int.MAX_VALUE }
}

private fun decimalValue(whole: String, fraction: String): Float {
    val decimals = fraction.take(RobolangLimits.DECIMAL_DIGITS - whole.length)
    val powerOfTen = (1..decimals.length).fold(1L) { power, _ -> power * 10 }
    return ((whole + decimals).toLong().toDouble() / powerOfTen.toDouble()).toFloat()
}
