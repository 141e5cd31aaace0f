package robotran.textediting.complete

import robotran.textediting.text.Draft
import robotran.textediting.text.TextSelection

/**
 * Something that may be meant by what is being written.
 *
 * @property label what is offered.
 * @property inserted what comes into the text, its further lines without the blanks of the line it stands in.
 * @property caret where the caret is in [inserted] afterwards.
 * @property help one line that says what it is for; null if nothing is known.
 * @property asksOn whether one of a few words has to follow, which are offered next.
 * @property selected how many characters before the caret are selected afterwards, for a value to be written over.
 */
data class Completion(
    val label: String,
    val kind: CompletionKind,
    val inserted: String = label,
    val caret: Int = inserted.length,
    val help: String? = null,
    val selected: Int = 0,
    val asksOn: Boolean = false,
) {
    /** Whether it is what was [typed] already, so that there is nothing left to offer. */
    internal fun isWritten(typed: String): Boolean =
        inserted.equals(typed, ignoreCase = true) || label.equals(typed, ignoreCase = true)
}

/** A call of [name], with the caret between its brackets. */
internal fun callOf(name: String, kind: CompletionKind): Completion = Completion(
    "$name()",
    kind,
    "$name()",
    name.length + 1,
)

/** What can be offered. */
enum class CompletionKind { WORD, BLOCK, NAME, FUNCTION, METHOD, FIELD, CLASS }

/**
 * What is offered at a place.
 *
 * @property start where that which is completed begins; it ends at the caret.
 * @property items the most likely first; never empty.
 */
data class CompletionList(val start: Int, val items: List<Completion>)

/** Says in a line what a word of a language is for. */
fun interface WordHelp {
    /** A sentence about [word] in the reader's language; null if there is none. */
    fun of(word: String): String?
}

/** This text with [chosen] of [list] in it. */
fun Draft.completed(list: CompletionList, chosen: Completion): Draft {
    val line = lines.lineOf(list.start)
    val indent = lines.line(line).takeWhile { it == ' ' }
    val inserted = chosen.inserted.replace("\n", "\n" + indent)
    val caret = chosen.inserted.take(chosen.caret).replace("\n", "\n" + indent).length
    val place = list.start + caret
    return replaced(
        list.start,
        selection.caret,
        inserted,
    ).copy(selection = TextSelection(place - chosen.selected, place))
}

/**
 * Those of [candidates] that [typed] may become: first those that begin with it, then those that have it at the
 * beginning of a part.
 */
internal fun matching(typed: String, candidates: List<Completion>): List<Completion> {
    val (starting, others) = candidates.partition { it.label.startsWith(typed, ignoreCase = true) }
    val inside = others.filter { typed.length >= MIN_INSIDE && hasPart(it.label, typed) }
    return (starting + inside).distinctBy { it.label to it.inserted }.take(MAX_ITEMS)
}

private fun hasPart(label: String, typed: String): Boolean {
    var place = label.indexOf(typed, 1, ignoreCase = true)
    while (place > 0) {
        if (label[place].isUpperCase() || !label[place - 1].isLetterOrDigit()) return true
        place = label.indexOf(typed, place + 1, ignoreCase = true)
    }
    return false
}

private const val MIN_INSIDE = 2
private const val MAX_ITEMS = 60
