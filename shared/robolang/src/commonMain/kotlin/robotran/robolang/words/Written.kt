package robotran.robolang.words

/**
 * [english], a piece of a program in the words of English, in these words. What is no word of English stays: names, also
 * those for which [isName] holds, texts, comments, and what is in these words already.
 *
 * @param isName is asked for words in lower case.
 */
fun Vocabulary.written(english: String, isName: (String) -> Boolean = { false }): String =
    piece(english, Vocabulary.ENGLISH, this, isName)

/** [text], a piece of a program in these words, in those of English. */
fun Vocabulary.inEnglish(text: String): String = piece(text, this, Vocabulary.ENGLISH) { false }

private fun piece(text: String, from: Vocabulary, to: Vocabulary, isName: (String) -> Boolean): String {
    if (from === to) return text
    val pieces = PIECE.findAll(text).toList()
    val first = from.keyword(pieces.firstOrNull()?.value.orEmpty())
    val keywords = pieces.map { if (isName(lowercaseKeyword(it.value))) null else from.keyword(it.value, first) }
    return buildString {
        var position = 0
        pieces.forEachIndexed { index, piece ->
            val keyword = keywords[index] ?: return@forEachIndexed
            val start = piece.range.first
            val before = text.substring(0, start).trimEnd(' ')
            val isFirst = (start == 0 && piece.value.length < text.length) || before.endsWith('\n')
            append(text, position, start)
            append(to.text(keyword, WordPlace(isFirst, endsInOne(before), keywords.getOrNull(index + 1))))
            position = piece.range.last + 1
        }
        append(text, position, text.length)
    }
}

private fun endsInOne(text: String): Boolean = text == "1" || text.endsWith(" 1")

/** [sentence] with the code that it quotes in these words. See [written]. */
fun Vocabulary.quoted(sentence: String, isName: (String) -> Boolean = { false }): String {
    if (this === Vocabulary.ENGLISH) return sentence
    val pieces = sentence.split('"')
    if (pieces.size % 2 == 0) return sentence
    return pieces.mapIndexed { index, piece ->
        if (index % 2 == 1) written(piece, isName) else piece
    }.joinToString("\"")
}

/** The words of [text] in lower case. */
internal fun wordsOf(text: String): Set<String> = WORD.findAll(text).map { lowercaseKeyword(it.value) }.toSet()

/** [unit] in these words, as it agrees with [number]; [unit] as it is if it is none in these words. */
fun Vocabulary.agreeing(unit: String, number: String): String {
    val keyword = keyword(unit)?.takeIf { it in COUNTED } ?: return unit
    return text(keyword, WordPlace(isFirst = false, isBehindOne = number == "1", next = null))
}

private val COUNTED = setOf(Keyword.TIMES, Keyword.DEGREES, Keyword.SECONDS, Keyword.MILLISECONDS)
private val WORD = Regex("[A-Za-z][A-Za-z0-9_]*")

/** A text, a comment, or a word, also one of another alphabet. */
private val PIECE = Regex("\"[^\"\n]*\"|//[^\n]*|[A-Za-z_\u00C0-\u024F][A-Za-z0-9_\u00C0-\u024F]*")
