package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.TextLines
import robotran.programs.support

/**
 * The help on one word of a program.
 *
 * @property word the word, in Java with its class, such as `forward` or `Motor.forward`.
 * @property sentence one sentence that says what it does.
 * @property sentenceLanguage the language of [sentence]: English if there is no translation.
 * @property forms its syntax, in one or more forms.
 * @property example a few whole lines to try it with; null if there is none.
 * @property title the word as programs of the pupil have it.
 */
data class WordHelp(
    val word: String,
    val sentence: String,
    val sentenceLanguage: Language,
    val forms: List<String>,
    val example: String?,
    val title: String = word,
) {
    /** The same with its program text, in the usual words of [code], in those of [words]. */
    fun inWords(code: LanguageSupport, words: Language): WordHelp = if (words == Language.ENGLISH) {
        this
    } else {
        copy(
            sentence = code.markedInWords(sentence, words),
            forms = forms.map { code.pieceInWords(it, words) },
            example = example?.let { code.inWords(it, words) },
            title = code.pieceInWords(word, words),
        )
    }

    companion object {
        /**
         * Returns the help in [language] on a [word] of [programLanguage] for a [brick], such as `forward` or `Motor.forward`;
         * null if there is none.
         */
        fun of(language: Language, programLanguage: ProgramLanguage, word: String, brick: BrickKind): WordHelp? =
            programLanguage.help?.on(word, language, brick)

        /** The words of a programming language that have an entry, in the order of their file. */
        fun words(programLanguage: ProgramLanguage, brick: BrickKind): List<String> =
            programLanguage.help?.words(brick).orEmpty()
    }
}

/**
 * Returns the help on the word of the program [text] that [offset] is in or at the end of; null if there is no word or
 * no help, and in comments.
 *
 * @param language the pupil's language.
 * @param programLanguage the language of the program.
 * @param brick the robot's brick; the program may name another.
 */
fun helpOn(
    language: Language,
    programLanguage: ProgramLanguage,
    text: String,
    offset: Int,
    brick: BrickKind,
): WordHelp? {
    val range = wordRange(text, offset) ?: return null
    return programLanguage.help?.at(
        text,
        range,
        language,
        programLanguage.support.code.brickOf(TextLines(text)) ?: brick,
    )
}

/** Returns the word of [text] that [offset] is in or at the end of; null if there is none or it is in a comment. */
fun wordAt(text: String, offset: Int): String? = wordRange(text, offset)?.let { text.substring(it.first, it.last + 1) }

internal fun wordRange(text: String, offset: Int): IntRange? {
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
