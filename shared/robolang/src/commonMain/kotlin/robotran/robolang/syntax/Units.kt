package robotran.robolang.syntax

import robotran.robolang.words.Keyword
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.lowercaseKeyword

/** Other spellings of the units of Robolang. */
private val OTHER_SPELLINGS: Map<String, Keyword> = mapOf(
    "centimetre" to Keyword.CM,
    "centimetres" to Keyword.CM,
    "centimeter" to Keyword.CM,
    "centimeters" to Keyword.CM,
    "cms" to Keyword.CM,
    "deg" to Keyword.DEGREES,
    "s" to Keyword.SECONDS,
    "sec" to Keyword.SECONDS,
    "secs" to Keyword.SECONDS,
    "ms" to Keyword.MILLISECONDS,
    "msec" to Keyword.MILLISECONDS,
    "millis" to Keyword.MILLISECONDS,
)

/** Units that Robolang does not have. */
private val OTHER_UNITS: Set<String> = setOf(
    "mm",
    "m",
    "km",
    "metre",
    "metres",
    "meter",
    "meters",
    "inch",
    "inches",
    "foot",
    "feet",
    "steps",
    "pixels",
    "minute",
    "minutes",
    "min",
    "mins",
    "hour",
    "hours",
    "h",
    "radians",
    "rad",
    "turns",
)

private val UNITS = setOf(Keyword.CM, Keyword.DEGREES, Keyword.SECONDS, Keyword.MILLISECONDS)

/** Whether [word] is any unit. */
internal fun isUnit(word: Token): Boolean {
    val spelling = lowercaseKeyword(word.text.take(LONGEST_SPELLING + 1))
    return word.keyword in UNITS || spelling in OTHER_SPELLINGS || spelling in OTHER_UNITS
}

/** The unit that [word] probably means. */
internal fun meantUnit(word: Token, units: List<Keyword>, vocabulary: Vocabulary): Keyword? {
    val abbreviated = OTHER_SPELLINGS[lowercaseKeyword(word.text.take(LONGEST_SPELLING + 1))]
    if (abbreviated != null) return abbreviated.takeIf { it in units }
    if (isUnit(word)) return null
    val text = suggestionIn(vocabulary, word.text, units.map { it.text })
    return units.firstOrNull { it.text == text }
}

private val LONGEST_SPELLING = (OTHER_SPELLINGS.keys + OTHER_UNITS).maxOf { it.length }
