package robotran.textediting

import robotran.textediting.text.TextDocument

/**
 * One change of a text.
 *
 * @property start the offset of the change.
 * @property removed the old text at [start].
 * @property inserted the new text at [start].
 */
data class TextEdit(val start: Int, val removed: String, val inserted: String) {
    /** The edit that undoes this one. */
    val inverse: TextEdit get() = TextEdit(start, inserted, removed)

    /** The change in the text's length. */
    val growth: Int get() = inserted.length - removed.length

    /** Returns [text] with this edit made. [text] must have [removed] at [start]. */
    fun applyTo(text: String): String = text.replaceRange(start, start + removed.length, inserted)

    /**
     * Returns the position of [offset] after this edit, or the end of [inserted] if [offset] was in the removed text.
     */
    fun moved(offset: Int): Int = when {
        offset < start -> offset
        offset >= start + removed.length -> offset + growth
        else -> start + inserted.length
    }
}

/** Returns the shortest single edit from [before] to [after]; null if they are equal. */
fun editBetween(before: String, after: String): TextEdit? {
    if (before == after) return null
    val max = minOf(before.length, after.length)
    var head = 0
    while (head < max && before[head] == after[head]) head++
    var tail = 0
    while (tail < max - head && before[before.length - 1 - tail] == after[after.length - 1 - tail]) tail++
    return TextEdit(head, before.substring(head, before.length - tail), after.substring(head, after.length - tail))
}

/** Returns the edit from [before] to [after], at the caret if several fit; null if the texts are equal. */
fun editBetween(before: TextDocument, after: TextDocument): TextEdit? {
    if (before.text == after.text) return null
    val typed = typedBetween(before, after) ?: return editBetween(before.text, after.text)
    return TextEdit(before.selection.start, before.selectedText, typed)
}

/** Returns the text that replaced the selection of [before], or null if [after] differs in anything else. */
internal fun typedBetween(before: TextDocument, after: TextDocument): String? {
    val start = before.selection.start
    val caret = after.selection.caret
    val growth = after.text.length - before.text.length
    val isPossible = after.selection.isEmpty && caret >= start && caret - start == before.selection.end - start + growth
    if (!isPossible) return null
    val isSame = after.text.regionMatches(0, before.text, 0, start) &&
        after.text.regionMatches(caret, before.text, before.selection.end, before.text.length - before.selection.end)
    return if (isSame) after.text.substring(start, caret) else null
}
