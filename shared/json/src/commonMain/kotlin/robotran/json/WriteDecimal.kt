package robotran.json

import kotlin.math.abs
import kotlin.math.floor

/**
 * The shortest decimal number without exponent that [readDecimal] reads as [number]; if there is none, the nearest with
 * fifteen significant digits. The same on every target, because it uses only exact and correctly rounded operations.
 *
 * @param number finite, its absolute value below 1e15 or exactly a result of [readDecimal].
 */
fun writeDecimal(number: Double): String {
    require(abs(number) < Double.POSITIVE_INFINITY) { "only finite numbers can be written" }
    val size = abs(number)
    if (size == 0.0) return "0"
    val sign = if (number < 0) "-" else ""
    if (size >= MAX) return sign + longWhole(size)
    for (decimals in 0..EXACT_POWER_OF_TEN) {
        val power = powerOfTen(decimals)
        val scaled = size * power
        if (scaled >= MAX) break
        val digits = floor(scaled + HALF)
        if (digits / power == size) return sign + withPoint(digits.toLong(), decimals)
    }
    return sign + nearest(size)
}

/** The number nearest to [number] that [writeDecimal] and [readDecimal] preserve. */
fun nearestDecimal(number: Double): Double = checkNotNull(readDecimal(writeDecimal(number)))

/** From 1e15 on, where only the first digits are exact. */
private fun longWhole(size: Double): String {
    val zeros = (0..EXACT_POWER_OF_TEN).firstOrNull { size / powerOfTen(it) < MAX } ?: EXACT_POWER_OF_TEN
    return floor(size / powerOfTen(zeros) + HALF).toLong().toString() + "0".repeat(zeros)
}

private fun nearest(size: Double): String {
    val decimals = (0..EXACT_POWER_OF_TEN).last { size * powerOfTen(it) < MAX }
    val digits = floor(size * powerOfTen(decimals) + HALF).toLong()
    return withPoint(digits, decimals).let { if ('.' in it) it.trimEnd('0').trimEnd('.') else it }
}

private fun withPoint(digits: Long, decimals: Int): String {
    val padded = digits.toString().padStart(decimals + 1, '0')
    val whole = padded.dropLast(decimals)
    return if (decimals == 0) whole else "$whole.${padded.takeLast(decimals)}"
}

/** Fifteen digits. */
private const val MAX = 1e15
private const val HALF = 0.5
