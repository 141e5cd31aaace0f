package robotran.robolang.words

/** [english], a piece of a program in the words of English, in these words. Names that are in [names] stay. */
internal fun Vocabulary.written(english: String, names: Set<String> = emptySet()): String {
    if (this === Vocabulary.ENGLISH) return english
    val words = WORD.findAll(english).toList()
    val keywords = words.map { word ->
        if (lowercaseKeyword(word.value) in names) null else Vocabulary.ENGLISH.keyword(word.value, Keyword.FOR.takeIf { FOR in english })
    }
    return buildString {
        var position = 0
        words.forEachIndexed { index, word ->
            val keyword = keywords[index]
            if (keyword != null) {
                val isFirst = word.range.first == 0 && words.size > 1
                val isBehindOne = english.take(word.range.first).trimEnd().endsWith(" 1")
                append(english, position, word.range.first)
                append(text(keyword, WordPlace(isFirst, isBehindOne, keywords.getOrNull(index + 1))))
                position = word.range.last + 1
            }
        }
        append(english, position, english.length)
    }
}

/** The words of [text] in lower case. */
internal fun wordsOf(text: String): List<String> = WORD.findAll(text).map { lowercaseKeyword(it.value) }.toList()

/** [sentence] with the code that it quotes in these words. Names that are in [names] stay. */
internal fun Vocabulary.quoted(sentence: String, names: Set<String>): String {
    val pieces = sentence.split('"')
    if (pieces.size % 2 == 0) return sentence
    return pieces.mapIndexed { index, piece -> if (index % 2 == 1) written(piece, names) else piece }.joinToString("\"")
}

private const val FOR = "for "
private val WORD = Regex("[A-Za-z][A-Za-z0-9_]*")
