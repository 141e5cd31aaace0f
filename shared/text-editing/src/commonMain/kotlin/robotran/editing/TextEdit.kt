package robotran.editing

/**
 * One change of a text.
 *
 * @property start where it is.
 * @property removed what was there.
 * @property inserted what is there now.
 */
data class TextEdit(
    val start: Int,
    val removed: String,
    val inserted: String,
) {
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
    val most = minOf(before.length, after.length)
    var head = 0
    while (head < most && before[head] == after[head]) head++
    var tail = 0
    while (tail < most - head && before[before.length - 1 - tail] == after[after.length - 1 - tail]) tail++
    return TextEdit(head, before.substring(head, before.length - tail), after.substring(head, after.length - tail))
}
