package robotran.editing

import robotran.json.nearestDecimal
import robotran.json.readDecimal
import robotran.json.writeDecimal
import kotlin.math.floor

/** To thousandths of a centimetre or a degree: not visible, and short in a file. */
fun rounded(number: Double): Double = floor(number * THOUSAND + HALF) / THOUSAND

/** [number] as a user reads it, with at most three decimals and no trailing zeros. */
fun written(number: Double): String = writeDecimal(rounded(number))

/** Parses a number typed with a point or a comma; null if it is invalid. */
fun parseDecimal(text: String): Double? {
    val plain = text.trim().replace(',', '.').replace('−', '-').removePrefix("+").removeSuffix(".")
    val whole = if (plain.startsWith(".")) "0$plain" else plain.replace(Regex("^(-?)0+(?=\\d)"), "$1")
    return whole.takeIf { it.length <= MAX_CHARACTERS && PLAIN.matches(it) }?.let(::readDecimal)?.let(::nearestDecimal)
}

private val PLAIN = Regex("-?\\d+(\\.\\d+)?")
private const val THOUSAND = 1000.0
private const val HALF = 0.5
private const val MAX_CHARACTERS = 20
