package robotran.nqc.edit

/**
 * One entry of a list of completions.
 *
 * @property label the text in the list.
 * @property inserted the inserted text; its further lines lack the indentation of the current line.
 * @property caret the offset of the caret in [inserted] afterwards.
 * @property help a sentence in the pupil's language; null if there is none.
 */
data class NqcCompletion(
    val label: String,
    val kind: NqcCompletionKind,
    val inserted: String = label,
    val caret: Int = inserted.length,
    val help: String? = null,
)

enum class NqcCompletionKind { WORD, BLOCK, NAME, FUNCTION, VALUE, CONSTANT }

/**
 * The completions at a place of a program.
 *
 * @property start where the completed word begins; it ends at the caret.
 * @property typed the part of the word that is written.
 * @property items what can be there, the likeliest first, whether or not it begins with [typed].
 */
data class NqcCompletions(val start: Int, val typed: String, val items: List<NqcCompletion>)
