package robotran.robolang.run

/**
 * [value] as in a program, with at most seven digits, such as `2.5`, `-0.125` or `1.5E10`. The same on every target;
 * the platforms' own conversions differ.
 */
internal fun decimalText(value: Float): String {
    val magnitude = (if (value < 0f) -value else value).toDouble()
    val sign = if (value < 0f) "-" else ""
    return when {
        value != value -> "NaN"
        magnitude > Float.MAX_VALUE -> "${sign}Infinity"
        magnitude == 0.0 -> "0.0"
        magnitude >= PLAIN_BELOW || magnitude < PLAIN_FROM -> sign + scientific(magnitude)
        else -> sign + plain(magnitude)
    }
}

private const val PLAIN_FROM = 1e-3
private const val PLAIN_BELOW = 1e7
private const val DIGITS_FROM = 1e6

/** Writes seven significant digits, without trailing zeros. */
private fun plain(magnitude: Double): String {
    var scaled = magnitude
    var decimals = 0
    while (scaled < DIGITS_FROM) {
        scaled *= 10
        decimals++
    }
    val digits = (scaled + 0.5).toLong().toString().padStart(decimals + 1, '0')
    val fraction = digits.takeLast(decimals).trimEnd('0').ifEmpty { "0" }
    return "${digits.dropLast(decimals)}.$fraction"
}

private fun scientific(magnitude: Double): String {
    var mantissa = magnitude
    var exponent = 0
    while (mantissa >= 10) {
        mantissa /= 10
        exponent++
    }
    while (mantissa < 1) {
        mantissa *= 10
        exponent--
    }
    return "${plain(mantissa)}E$exponent"
}
