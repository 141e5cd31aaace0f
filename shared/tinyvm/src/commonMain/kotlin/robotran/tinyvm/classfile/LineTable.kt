package robotran.tinyvm.classfile

/**
 * Maps byte positions in a method's code to source lines.
 *
 * @param starts byte positions, ascending.
 * @param lines the source line that begins at each of them.
 */
class LineTable(private val starts: IntArray, private val lines: IntArray) {
    /** The source line of the byte at [position], 0 if unknown. */
    fun lineAt(position: Int): Int {
        var low = 0
        var high = starts.size
        while (low < high) {
            val middle = (low + high) / 2
            if (starts[middle] <= position) low = middle + 1 else high = middle
        }
        return if (low == 0) 0 else lines[low - 1]
    }

    /** The byte positions where lines begin. */
    val lineStarts: Set<Int> get() = starts.toSet()
}
