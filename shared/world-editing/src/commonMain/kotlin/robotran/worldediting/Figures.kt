package robotran.worldediting

import robotran.json.nearestDecimal
import robotran.json.readDecimal
import robotran.json.writeDecimal

/** [number] as a person reads it, with no more than three decimals and no others than it needs. */
fun written(number: Double): String = writeDecimal(rounded(number))

/** The number that a person has typed, with a point or a comma; null if it is none. */
fun readFigure(text: String): Double? {
    val plain = text.trim().replace(',', '.').replace('−', '-').removePrefix("+").removeSuffix(".")
    val whole = if (plain.startsWith(".")) "0$plain" else plain.replace(Regex("^(-?)0+(?=\\d)"), "$1")
    return whole.takeIf { it.length <= MAX_CHARACTERS && PLAIN.matches(it) }?.let(::readDecimal)?.let(::nearestDecimal)
}

private val PLAIN = Regex("-?\\d+(\\.\\d+)?")
private const val MAX_CHARACTERS = 20
