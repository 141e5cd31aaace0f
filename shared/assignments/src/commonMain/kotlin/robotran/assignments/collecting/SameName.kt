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

/**
 * Whether a folder is called [folder] after one pupil, so that all that lies in it is this pupil's. It is not if it is
 * called "7b", or if what lies in it has several [names] that are all other ones.
 */
internal fun isNameOfOne(folder: String, names: Collection<String>): Boolean =
    wordsOf(folder.substringAfterLast('/')).isNotEmpty() &&
        (names.size < 2 || names.any { mayBeSamePerson(it, folder) })

private fun wordsOf(name: String): List<String> =
    foldedName(name).map { if (it.isLetter()) it else ' ' }.joinToString("").split(' ')
        .map { word -> UMLAUTS.fold(word) { text, (written, letter) -> text.replace(written, letter) } }
        .filter { it.length >= FEWEST_LETTERS }

private val UMLAUTS = listOf("ae" to "a", "oe" to "o", "ue" to "u")
private const val FEWEST_LETTERS = 2
