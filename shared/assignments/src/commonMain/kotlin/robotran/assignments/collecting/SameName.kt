package robotran.assignments.collecting

/**
 * Whether both may be names of one person: they share a word, or one has a word of the other in it, as in `meyeranna`.
 * Umlauts are the same as what is written for them.
 */
internal fun mayBeSamePerson(one: String, other: String): Boolean {
    val words = wordsOf(one)
    val others = wordsOf(other)
    // Nothing can be said about "7b".
    if (words.isEmpty() || others.isEmpty()) return true
    return words.any { it in others.joinToString("") } || others.any { it in words.joinToString("") }
}

private fun wordsOf(name: String): List<String> =
    foldedName(name).map { if (it.isLetter()) it else ' ' }.joinToString("").split(' ')
        .map { word -> UMLAUTS.fold(word) { text, (written, letter) -> text.replace(written, letter) } }
        .filter { it.length >= FEWEST_LETTERS }

private val UMLAUTS = listOf("ae" to "a", "oe" to "o", "ue" to "u")
private const val FEWEST_LETTERS = 2
