package robotran.robolang.words

/**
 * The words that the program [source] is written in: those of the language in which most of its lines begin with a
 * command; of several, those that know most of its words; if none is better, those [unsure]. Never throws, and takes time
 * linear in the length of [source].
 */
fun vocabularyOf(source: String, unsure: Vocabulary = Vocabulary.ENGLISH): Vocabulary {
    val lines = source.lineSequence().mapNotNull(::lineOf).toList()
    val best = best(Vocabulary.all) { words -> lines.count { it.isCommandIn(words) } }
    best.singleOrNull()?.let { return it }
    val closest = best(best) { words -> lines.sumOf { it.wordsIn(words) } }
    return unsure.takeIf { it in closest } ?: closest.first()
}

private fun best(vocabularies: List<Vocabulary>, score: (Vocabulary) -> Int): List<Vocabulary> {
    val scores = vocabularies.associateWith(score)
    val highest = scores.values.max()
    return vocabularies.filter { scores.getValue(it) == highest }
}

/** The first [word] of a line, empty if it begins with something else, and the [rest]. */
private class Line(private val word: String, private val rest: String) {
    private val assignsOrCalls = rest.startsWith('(') || rest.trimStart(::isBlank).firstOrNull() in ASSIGNING

    fun isCommandIn(vocabulary: Vocabulary): Boolean = !assignsOrCalls && vocabulary.keyword(word) in Keyword.COMMANDS

    /** How many of its words are keywords of [vocabulary]. Single letters are names rather than keywords. */
    fun wordsIn(vocabulary: Vocabulary): Int = wordsOfCode("$word $rest").count {
        it.length > 1 &&
            vocabulary.keyword(it) != null
    }
}

private fun lineOf(text: String): Line? {
    val start = text.indexOfFirst { !isBlank(it) && it != BYTE_ORDER }
    if (start < 0) return null
    val word = text.substring(start).takeWhile { isLetter(it) || isDigit(it) }
    return Line(word, text.substring(start + word.length))
}

private const val BYTE_ORDER = '\uFEFF'
private val ASSIGNING = setOf('=', '[')

/** The words of [code], without those in its text and its comment. */
private fun wordsOfCode(code: String): Sequence<String> =
    WORD.findAll(code.substringBefore("//").substringBefore('"')).map { it.value }

private val WORD = Regex("[A-Za-z_\u00C0-\u024F][A-Za-z0-9_\u00C0-\u024F]*")
