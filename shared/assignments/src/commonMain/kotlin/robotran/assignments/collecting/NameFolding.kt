package robotran.assignments.collecting

import robotran.language.Language

/**
 * By this, names stand in the order in which people in [language] look for them: accents and capitals do not count, and
 * in Spanish `ñ` has its place after `n`.
 */
fun sortKey(name: String, language: Language): String = foldedName(name) { letter ->
    "n\uFFFF".takeIf { letter == 'ñ' && language == Language.SPANISH }
}

/** The order of a teacher's own list in [language]; of equal names, that of files. */
fun byName(language: Language): Comparator<Submission> =
    compareBy({ sortKey(it.name, language) }, { it.name }, { it.origin })

/** The same for names that differ only in case, blanks and how letters with accents are stored. */
fun keyOf(name: String): String = composed(name).filterNot { it.isWhitespace() }.lowercase()

/** [name] in small letters without accents. */
internal fun foldedName(name: String, special: (Char) -> String? = { null }): String =
    composed(name.lowercase()).filterNot { it in COMBINING_MARKS }
        .map { special(it) ?: FOLDED[it] ?: it.toString() }.joinToString("")

/** [text] with one letter where a Mac stores the names of files with two: a letter and its accent. */
fun composed(text: String): String {
    if (text.none { it in COMBINING_MARKS }) return text
    val letters = StringBuilder()
    for (letter in text) {
        val whole = letters.lastOrNull()?.let { COMPOSED[it to letter] }
        if (whole == null) letters.append(letter) else letters[letters.length - 1] = whole
    }
    return letters.toString()
}

private val COMBINING_MARKS = '\u0300'..'\u036F'

/** By letter and accent, those that European names have. */
private val COMPOSED: Map<Pair<Char, Char>, Char> = listOf(
    Triple('\u0300', "aeiouAEIOU", "àèìòùÀÈÌÒÙ"),
    Triple('\u0301', "aeiouycnszlrAEIOUYCNSZLR", "áéíóúýćńśźĺŕÁÉÍÓÚÝĆŃŚŹĹŔ"),
    Triple('\u0302', "aeioucghjswyAEIOUCGHJSWY", "âêîôûĉĝĥĵŝŵŷÂÊÎÔÛĈĜĤĴŜŴŶ"),
    Triple('\u0303', "anoANO", "ãñõÃÑÕ"),
    Triple('\u0304', "aeiouAEIOU", "āēīōūĀĒĪŌŪ"),
    Triple('\u0306', "aguAGU", "ăğŭĂĞŬ"),
    Triple('\u0307', "cegzCEGZI", "ċėġżĊĖĠŻİ"),
    Triple('\u0308', "aeiouyAEIOUY", "äëïöüÿÄËÏÖÜŸ"),
    Triple('\u030A', "auAU", "åůÅŮ"),
    Triple('\u030B', "ouOU", "őűŐŰ"),
    Triple('\u030C', "cdenrstzCDENRSTZ", "čďěňřšťžČĎĚŇŘŠŤŽ"),
    Triple('\u0327', "cstgklnrCSTGKLNR", "çşţģķļņŗÇŞŢĢĶĻŅŖ"),
    Triple('\u0328', "aeiuAEIU", "ąęįųĄĘĮŲ"),
).flatMap { (mark, letters, whole) -> letters.zip(whole) { letter, both -> (letter to mark) to both } }.toMap()

private val FOLDED: Map<Char, String> = listOf(
    "a" to "àáâãäåāăą",
    "c" to "çćĉċč",
    "d" to "ďđð",
    "e" to "èéêëēĕėęě",
    "g" to "ĝğġģ",
    "h" to "ĥħ",
    "i" to "ìíîïĩīĭįı",
    "j" to "ĵ",
    "k" to "ķ",
    "l" to "ĺļľŀł",
    "n" to "ñńņňŋ",
    "o" to "òóôõöøōŏő",
    "r" to "ŕŗř",
    "s" to "śŝşšș",
    "t" to "ţťŧț",
    "u" to "ùúûüũūŭůűų",
    "w" to "ŵ",
    "y" to "ýÿŷ",
    "z" to "źżž",
    "ss" to "ß",
    "ae" to "æ",
    "oe" to "œ",
    "th" to "þ",
).flatMap { (base, letters) -> letters.map { it to base } }.toMap()
