package robotran.robolang.words

/**
 * [english], a piece of a program in the words of English, in these words. What is no word of English stays: names, also
 * those in [names], texts, comments, and what is in these words already.
 *
 * @param names in lower case.
 */
fun Vocabulary.written(english: String, names: Set<String> = emptySet()): String {
    if (this === Vocabulary.ENGLISH) return english
    val pieces = PIECE.findAll(english).toList()
    val first = english.trimStart().takeWhile { it.isLetter() }
    val line = Keyword.FOR.takeIf { first.equals(it.text, ignoreCase = true) }
    val keywords = pieces.map { piece ->
        if (lowercaseKeyword(piece.value) in names) null else Vocabulary.ENGLISH.keyword(piece.value, line)
    }
    return buildString {
        var position = 0
        pieces.forEachIndexed { index, piece ->
            val keyword = keywords[index] ?: return@forEachIndexed
            val start = piece.range.first
            val before = english.substring(0, start).trimEnd(' ')
            val isFirst = before.isEmpty() && pieces.size > 1 && start == 0 || before.endsWith('\n')
            append(english, position, start)
            append(text(keyword, WordPlace(isFirst, endsInOne(before), keywords.getOrNull(index + 1))))
            position = piece.range.last + 1
        }
        append(english, position, english.length)
    }
}

private fun endsInOne(text: String): Boolean = text == "1" || text.endsWith(" 1")

/** [sentence] with the code that it quotes in these words. Names that are in [names] stay. */
internal fun Vocabulary.quoted(sentence: String, names: Set<String>): String {
    val pieces = sentence.split('"')
    if (pieces.size % 2 == 0) return sentence
    return pieces.mapIndexed { index, piece -> if (index % 2 == 1) written(piece, names) else piece }.joinToString("\"")
}

/** The words of [text] in lower case. */
internal fun wordsOf(text: String): List<String> =
    WORD.findAll(text).map { lowercaseKeyword(it.value) }.toList()

/** [unit] in these words, as it agrees with [number]; [unit] as it is if it is none in these words. */
fun Vocabulary.agreeing(unit: String, number: String): String {
    val keyword = keyword(unit)?.takeIf { it in COUNTED } ?: return unit
    return text(keyword, WordPlace(isFirst = false, isBehindOne = number == "1", next = null))
}

private val COUNTED = setOf(Keyword.TIMES, Keyword.DEGREES, Keyword.SECONDS, Keyword.MILLISECONDS)
private val WORD = Regex("[A-Za-z][A-Za-z0-9_]*")

/** A text, a comment, or a word, also one of another alphabet. */
private val PIECE = Regex("\"[^\"\n]*\"|//[^\n]*|[A-Za-z_\u00C0-\u024F][A-Za-z0-9_\u00C0-\u024F]*")
