package robotran.textediting.rows

/** A line with its tabs expanded to spaces. */
class ShownLine(line: String) {
    val length: Int = line.length
    private val columns: IntArray? = if ('\t' in line) columnsOf(line) else null

    val text: String = if (columns == null) {
        line
    } else {
        buildString {
            line.forEachIndexed { index, character ->
                if (character == '\t') append(" ".repeat(columns[index + 1] - columns[index])) else append(character)
            }
        }
    }

    /** The index of [column] in [text]. */
    fun column(column: Int): Int = columns?.get(column) ?: column

    /** The column for the index [shown] in [text]. */
    fun sourceColumn(shown: Int): Int {
        val places = columns ?: return shown
        return places.indexOfLast { it <= shown }.coerceAtLeast(0)
    }

    private fun columnsOf(line: String): IntArray {
        val places = IntArray(line.length + 1)
        line.forEachIndexed { index, character ->
            places[index + 1] = if (character == '\t') (places[index] / TAB + 1) * TAB else places[index] + 1
        }
        return places
    }

    private companion object {
        const val TAB = 4
    }
}
