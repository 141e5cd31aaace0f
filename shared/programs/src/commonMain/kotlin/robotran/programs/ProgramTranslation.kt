package robotran.programs

import robotran.language.ShownLanguage

/**
 * A program as another text.
 *
 * @property language that of the [text].
 * @property fileName the name of a file with it.
 * @property notes what is lost or changed in it, in whole sentences with the line of the program.
 * @param origins for each line of the text, the line of the program that it comes from; null for a line of its own.
 */
class ProgramTranslation internal constructor(
    val language: ShownLanguage,
    val fileName: String,
    val text: String,
    private val origins: List<SourceLine?>,
    val notes: List<TranslationNote> = emptyList(),
) {
    private val linesOf: Map<SourceLine?, List<Int>> by lazy(LazyThreadSafetyMode.NONE) {
        origins.indices.groupBy({ origins[it] }, { it + 1 })
    }

    /** The lines of the text, from 1, that come from the line [line], from 1, of the file [file], in order. */
    fun linesOf(file: String, line: Int): List<Int> = linesOf[SourceLine(file, line)].orEmpty()

    /** Where the line [line] of the text, from 1, comes from; null if it belongs to no line of the program. */
    fun originOf(line: Int): SourceLine? = origins.getOrNull(line - 1)
}

/** A [line], from 1, in a [file] of a program. */
data class SourceLine(val file: String, val line: Int)

/** What is different in a translation: a [message] about a [line], from 1, of the program. */
data class TranslationNote(val line: Int, val message: String)
