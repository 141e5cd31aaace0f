package robotran.textediting.text

/** Where the lines of [text] are; they end in `\n` and count from 0. Even an empty text has one. */
class TextLines(val text: String) {
    private val starts: IntArray = startsOf(text)

    val count: Int get() = starts.size

    /** Where [line] begins. */
    fun start(line: Int): Int = starts[line]

    /** Where [line] ends, before its line end. */
    fun end(line: Int): Int = if (line + 1 < starts.size) starts[line + 1] - 1 else text.length

    /** [line] without its line end. */
    fun line(line: Int): String = text.substring(start(line), end(line))

    /** The line that the place [offset] is in, 0 to the text's length. */
    fun lineOf(offset: Int): Int {
        var low = 0
        var high = starts.size - 1
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (starts[middle] <= offset) low = middle else high = middle - 1
        }
        return low
    }

    /** How far into its line [offset] is, from 0. */
    fun columnOf(offset: Int): Int = offset - start(lineOf(offset))

    /** The place of [column] in [line], or the line's end if it is shorter. */
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
