package robotran.languagesupport

import robotran.language.Language

/**
 * One entry of the completion list.
 *
 * @property label the text in the list.
 * @property inserted the inserted text; its further lines lack the indentation of the current line.
 * @property caret the offset of the caret in [inserted] afterwards.
 * @property help one line of help; null if there is none.
 * @property offersNext whether one of a few words must follow, which are offered next.
 * @property selected how many characters before the caret are selected afterwards, so that typing replaces them.
 */
data class Completion(
    val label: String,
    val kind: CompletionKind,
    val inserted: String = label,
    val caret: Int = inserted.length,
    val help: String? = null,
    val selected: Int = 0,
    val offersNext: Boolean = false,
) {
    /** Whether [typed] is already the whole completion. */
    internal fun isWritten(typed: String): Boolean =
        inserted.equals(typed, ignoreCase = true) || label.equals(typed, ignoreCase = true)
}

/** A call of [name], with the caret between its parentheses. */
fun callOf(name: String, kind: CompletionKind): Completion = Completion(
    "$name()",
    kind,
    "$name()",
    name.length + 1,
)

enum class CompletionKind { WORD, BLOCK, NAME, FUNCTION, METHOD, FIELD, CLASS }

/**
 * The completions at a position.
 *
 * @property start the offset at which the completed text begins; it ends at the caret.
 * @property items the completions, most likely first; never empty.
 */
data class CompletionList(val start: Int, val items: List<Completion>)

/** Provides one line of help for a word of a language. */
fun interface CompletionHelp {
    /** The language whose words a new program has. */
    val words: Language get() = Language.ENGLISH

    /** A sentence about [word] in the pupil's language; null if there is none. */
    fun of(word: String): String?
}

/** The [candidates] that match [typed]: first those that begin with it, then those with a later part that does. */
internal fun matching(typed: String, candidates: List<Completion>): List<Completion> {
    val (starting, others) = candidates.partition { it.label.startsWith(typed, ignoreCase = true) }
    val inside = others.filter { typed.length >= MIN_INSIDE && hasPart(it.label, typed) }
    return (starting + inside).distinctBy { it.label to it.inserted }.take(MAX_ITEMS)
}

private fun hasPart(label: String, typed: String): Boolean {
    var position = label.indexOf(typed, 1, ignoreCase = true)
    while (position > 0) {
        if (label[position].isUpperCase() || !label[position - 1].isLetterOrDigit()) return true
        position = label.indexOf(typed, position + 1, ignoreCase = true)
    }
    return false
}

private const val MIN_INSIDE = 2
private const val MAX_ITEMS = 60
