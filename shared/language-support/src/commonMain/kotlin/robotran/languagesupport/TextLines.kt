package robotran.languagesupport

/** The lines of [text]. They end in `\n`, and their indices begin at 0. An empty text has one line. */
class TextLines(val text: String) {
    private val starts: IntArray = startsOf(text)

    val count: Int get() = starts.size

    /** The offset at which [line] begins. */
    fun start(line: Int): Int = starts[line]

    /** The offset at which [line] ends, before its line break. */
    fun end(line: Int): Int = if (line + 1 < starts.size) starts[line + 1] - 1 else text.length

    /** The text of [line] without its line break. */
    fun line(line: Int): String = text.substring(start(line), end(line))

    /** The index of the line that contains [offset], which is from 0 to the text's length. */
    fun lineOf(offset: Int): Int {
        var low = 0
        var high = starts.size - 1
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (starts[middle] <= offset) low = middle else high = middle - 1
        }
        return low
    }

    /** The column of [offset] in its line, from 0. */
    fun columnOf(offset: Int): Int = offset - start(lineOf(offset))

    /** The offset of [column] in [line], or the end of the line if it is shorter. */
    fun offset(line: Int, column: Int): Int = minOf(start(line) + column, end(line))

    private companion object {
        fun startsOf(text: String): IntArray {
            var starts = IntArray(FIRST_CAPACITY)
            var count = 1
            var end = text.indexOf('\n')
            while (end >= 0) {
                if (count == starts.size) starts = starts.copyOf(count * 2)
                starts[count++] = end + 1
                end = text.indexOf('\n', end + 1)
            }
            return starts.copyOf(count)
        }

        const val FIRST_CAPACITY = 64
    }
}
