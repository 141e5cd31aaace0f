package robotran.learning

import robotran.language.Language
import robotran.language.ProgramLanguage

/**
 * What there is to know about one word of a program.
 *
 * @property word as it is written, with the class it belongs to in Java, such as `forward` or `Motor.forward`.
 * @property sentence one sentence that says what it does.
 * @property sentenceLanguage the language of [sentence]: English where nobody has translated it.
 * @property forms how it is written, one or more.
 * @property example a few lines to try it with, whole lines; null if there is none.
 */
data class WordHelp(
    val word: String,
    val sentence: String,
    val sentenceLanguage: Language,
    val forms: List<String>,
    val example: String?,
) {
    companion object {
        /**
         * The help on a [word] of [code], such as `forward` or `Motor.forward`, for speakers of [language]; null if
         * there is none.
         */
        fun of(language: Language, code: ProgramLanguage, word: String): WordHelp? = when (code) {
            ProgramLanguage.ROBOLANG -> robolangWords.help(lowercaseWord(word), language)
            ProgramLanguage.JAVA -> lejosHelp(word, language)
        }

        /** The words of a language for programs that somebody has written help for, in the order of their file. */
        fun words(code: ProgramLanguage): List<String> = when (code) {
            ProgramLanguage.ROBOLANG -> robolangWords.words
            ProgramLanguage.JAVA -> lejosWords.words
        }
    }
}

/**
 * The help on the word at [offset] of the program [text], or on the one that ends there; null where there is no word or
 * no help on it, and in comments.
 *
 * @param language what the reader speaks.
 * @param code what the program is written in.
 */
fun helpOn(language: Language, code: ProgramLanguage, text: String, offset: Int): WordHelp? {
    val place = wordPlace(text, offset) ?: return null
    return when (code) {
        ProgramLanguage.ROBOLANG -> WordHelp.of(language, code, text.substring(place.first, place.last + 1))
        ProgramLanguage.JAVA -> helpInJava(language, text, place)
    }
}

/** The word at [offset] of [text], or the one that ends there; null if there is none or if it is in a comment. */
fun wordAt(text: String, offset: Int): String? = wordPlace(text, offset)?.let { text.substring(it.first, it.last + 1) }

internal fun wordPlace(text: String, offset: Int): IntRange? {
    if (offset !in 0..text.length) return null
    var first = offset
    while (first > 0 && isInWord(text[first - 1])) first--
    var end = offset
    while (end < text.length && isInWord(text[end])) end++
    return if (first == end || text[first].isDigit() || isInComment(text, first)) null else first until end
}

private fun isInWord(character: Char) = character == '_' || character.isLetterOrDigit()

private fun isInComment(text: String, offset: Int): Boolean {
    val before = text.substring(text.lastIndexOf('\n', offset - 1) + 1, offset)
    val slashes = before.indexOf("//")
    return slashes >= 0 && before.take(slashes).count { it == '"' } % 2 == 0
}

/** Robolang's words are plain ASCII, and so is their lower case: the platforms disagree about some other letters. */
private fun lowercaseWord(word: String): String =
    buildString(word.length) { word.forEach { append(if (it in 'A'..'Z') it + ('a' - 'A') else it) } }
