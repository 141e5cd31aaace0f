package robotran.textediting

import robotran.textediting.text.Draft

/**
 * One change of a text.
 *
 * @property start where it is.
 * @property removed what was there.
 * @property inserted what is there now.
 */
data class TextEdit(val start: Int, val removed: String, val inserted: String) {
    /** What takes this change back. */
    val inverse: TextEdit get() = TextEdit(start, inserted, removed)

    /** How much longer the text became. */
    val growth: Int get() = inserted.length - removed.length

    /** [text], which must have [removed] at [start], with this change made. */
    fun applyTo(text: String): String = text.replaceRange(start, start + removed.length, inserted)

    /** Where what was at [offset] is now; the end of what was inserted if it was taken out. */
    fun moved(offset: Int): Int = when {
        offset < start -> offset
        offset >= start + removed.length -> offset + growth
        else -> start + inserted.length
    }
}

/** What makes [before] into [after], as short as one change can be; null if they are alike. */
fun editBetween(before: String, after: String): TextEdit? {
    if (before == after) return null
    val max = minOf(before.length, after.length)
    var head = 0
    while (head < max && before[head] == after[head]) head++
    var tail = 0
    while (tail < max - head && before[before.length - 1 - tail] == after[after.length - 1 - tail]) tail++
    return TextEdit(head, before.substring(head, before.length - tail), after.substring(head, after.length - tail))
}

/** What makes the text of [before] into that of [after]; where it could be at several places, where the caret was. */
fun editBetween(before: Draft, after: Draft): TextEdit? {
    if (before.text == after.text) return null
    val typed = typedBetween(before, after) ?: return editBetween(before.text, after.text)
    return TextEdit(before.selection.start, before.selectedText, typed)
}

/**
 * What was written in place of what is selected in [before], if that is all that makes it [after]; null if it is not.
 */
internal fun typedBetween(before: Draft, after: Draft): String? {
    val start = before.selection.start
    val caret = after.selection.caret
    val growth = after.text.length - before.text.length
    val isPossible = after.selection.isEmpty && caret >= start && caret - start == before.selection.end - start + growth
    if (!isPossible) return null
    val isSame = after.text.regionMatches(0, before.text, 0, start) &&
        after.text.regionMatches(caret, before.text, before.selection.end, before.text.length - before.selection.end)
    return if (isSame) after.text.substring(start, caret) else null
}
