package robotran.ui.program.editor

import robotran.textediting.rows.TextRows

/**
 * The positions of lines and the notes between them, in pixels from the text's top. Line indices start at 0. A line
 * takes as many rows as it is broken into.
 *
 * @property lineHeight the height of a row.
 * @property notes the notes in the order of their lines; several notes of one line are stacked.
 */
internal data class EditorGeometry(
    val lineHeight: Float,
    private val rows: TextRows,
    val notes: List<NoteBounds> = emptyList(),
) {
    val lines: Int get() = rows.lines.count

    /** The total height of all notes before each index, and of all notes at the end. */
    private val heightsBefore: FloatArray = FloatArray(notes.size + 1).also { sums ->
        notes.forEachIndexed { index, note -> sums[index + 1] = sums[index] + note.height }
    }

    val height: Float get() = rows.count * lineHeight + heightsBefore[notes.size]

    /** The top edge of [line]. */
    fun top(line: Int): Float {
        val before = notes.indexOfFirst { it.line >= line }
        return rows.before(line) * lineHeight + heightsBefore[if (before < 0) notes.size else before]
    }

    /** The height of all rows of [line], without its notes. */
    fun heightOf(line: Int): Float = rows.countOf(line) * lineHeight

    /** The top edge of the note at [index]. */
    fun noteTop(index: Int): Float = rows.before(notes[index].line + 1) * lineHeight + heightsBefore[index]

    /** The line at [y]; a note belongs to the line above it. */
    fun lineAt(y: Float): Int {
        var low = 0
        var high = lines - 1
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (top(middle) <= y) low = middle else high = middle - 1
        }
        return low
    }

    /** The row of [line] at [y]; a note belongs to the row above it. */
    fun rowAt(line: Int, y: Float): Int = ((y - top(line)) / lineHeight).toInt().coerceIn(0, rows.countOf(line) - 1)
}

/** A note under [line]. */
internal data class NoteBounds(val line: Int, val height: Float)
