package robotran.textediting.rows

import robotran.languagesupport.TextLines

/**
 * How the lines of a text are broken into rows of at most [columns] cells. The text itself is never changed. Only lines
 * that may be too long are looked at in detail, so this costs one look at each character.
 */
class TextRows(val lines: TextLines, val columns: Int = UNBROKEN) {
    private val firstRows = IntArray(lines.count + 1)

    init {
        for (line in 0..<lines.count) {
            val fits = fitsOneRow(lines.text, lines.start(line), lines.end(line), columns)
            firstRows[line + 1] = firstRows[line] + if (fits) 1 else of(line).count
        }
    }

    /** The number of rows of all lines. */
    val count: Int get() = firstRows[lines.count]

    /** How many rows there are before [line], which may be the number of lines. */
    fun before(line: Int): Int = firstRows[line]

    /** The number of rows of [line]. */
    fun countOf(line: Int): Int = firstRows[line + 1] - firstRows[line]

    /** The line that [row] belongs to. */
    fun lineOf(row: Int): Int {
        var low = 0
        var high = lines.count - 1
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (firstRows[middle] <= row) low = middle else high = middle - 1
        }
        return low
    }

    fun of(line: Int): LineRows = rowsOf(lines.line(line), columns)

    /** How many cells are left of a caret at [offset] in its row. */
    fun cellOf(offset: Int): Int = of(lines.lineOf(offset)).cellOf(lines.columnOf(offset))

    /** The offset [by] rows below [offset], or above it, as near to [cell] as the row allows. */
    fun vertically(offset: Int, by: Int, cell: Int): Int {
        val line = lines.lineOf(offset)
        val row = before(line) + of(line).rowOf(lines.columnOf(offset))
        val target = row + by
        return when {
            target < 0 && row == 0 -> 0
            target >= count && row == count - 1 -> lines.text.length
            else -> offsetAt(target.coerceIn(0, count - 1), cell)
        }
    }

    private fun offsetAt(row: Int, cell: Int): Int {
        val line = lineOf(row)
        return lines.offset(line, of(line).columnAt(row - before(line), cell))
    }

    /** The rows of the same text in as many columns are the same. */
    override fun equals(other: Any?): Boolean =
        other is TextRows && columns == other.columns && lines.text == other.lines.text

    override fun hashCode(): Int = lines.text.hashCode() * PRIME + columns

    companion object {
        /** No line is broken. */
        const val UNBROKEN: Int = Int.MAX_VALUE
        private const val PRIME = 31
    }
}
