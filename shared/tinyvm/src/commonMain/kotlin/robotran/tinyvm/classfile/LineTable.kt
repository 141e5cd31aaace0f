package robotran.tinyvm.classfile

/**
 * Which source line each part of a method's code came from.
 *
 * @param starts places in the code, ascending.
 * @param lines the line that begins at each of them.
 */
internal class LineTable(private val starts: IntArray, private val lines: IntArray) {
    /** The line that the byte at [place] belongs to, 0 if it is unknown. */
    fun lineAt(place: Int): Int {
        var low = 0
        var high = starts.size
        while (low < high) {
            val middle = (low + high) / 2
            if (starts[middle] <= place) low = middle + 1 else high = middle
        }
        return if (low == 0) 0 else lines[low - 1]
    }

    /** The places where lines begin. */
    val beginnings: Set<Int> get() = starts.toSet()
}
