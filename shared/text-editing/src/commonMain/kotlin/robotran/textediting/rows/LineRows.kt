package robotran.textediting.rows

import robotran.textediting.text.widthBefore

/**
 * A line as it is shown: in one row, or in several if it is wider than its editor. Blanks at the end of a row belong to
 * it and may reach beyond the editor's edge. Rows count from 0, and so do columns, which are those of the line.
 *
 * @property indent how many cells the rows below the first are indented.
 */
class LineRows internal constructor(val shown: ShownLine, val indent: Int, private val starts: IntArray) {
    val count: Int get() = starts.size

    /** Where [row] begins in the text of [shown]. */
    fun start(row: Int): Int = starts[row]

    /** Where [row] ends in the text of [shown]. */
    fun end(row: Int): Int = if (row + 1 < starts.size) starts[row + 1] else shown.text.length

    /** How many cells are free before the text of [row]. */
    fun indentOf(row: Int): Int = if (row == 0) 0 else indent

    /** The row in which a caret at [column] stands: where two rows meet, the lower one. */
    fun rowOf(column: Int): Int {
        val place = shown.column(column.coerceIn(0, shown.length))
        return starts.indexOfLast { it <= place }.coerceAtLeast(0)
    }

    /** How many cells are left of a caret at [column] in its row. */
    fun cellOf(column: Int): Int {
        val row = rowOf(column)
        val place = shown.column(column.coerceIn(0, shown.length))
        return indentOf(row) + (start(row)..<place).sumOf { cellsOf(shown.text[it]) }
    }

    /** The column of [row] that has [cell] cells before it, or the last one that has fewer. */
    fun columnAt(row: Int, cell: Int): Int {
        var left = indentOf(row)
        var place = start(row)
        val end = end(row)
        while (place < end && left + cellsOf(shown.text[place]) <= cell) left += cellsOf(shown.text[place++])
        if (place < end && shown.text[place].isLowSurrogate()) place++
        return columnOf(row, place)
    }

    /** The column for a caret in [row] at [place] in the text of [shown]: it does not slip into the row below. */
    fun columnOf(row: Int, place: Int): Int {
        val end = end(row)
        val last = if (row + 1 < count) end - widthBefore(shown.text, end) else end
        return shown.sourceColumn(place.coerceIn(start(row), last))
    }
}
