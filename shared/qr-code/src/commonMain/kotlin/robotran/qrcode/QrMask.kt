package robotran.qrcode

/** One of the eight mask patterns, which keep the data from looking like the function patterns. */
internal class QrMask(val number: Int) {
    fun turns(column: Int, row: Int): Boolean = when (number) {
        0 -> (column + row) % 2
        1 -> row % 2
        2 -> column % 3
        3 -> (column + row) % 3
        4 -> (column / 3 + row / 2) % 2
        5 -> column * row % 2 + column * row % 3
        6 -> (column * row % 2 + column * row % 3) % 2
        else -> ((column + row) % 2 + column * row % 3) % 2
    } == 0

    companion object {
        const val COUNT = 8
    }
}
