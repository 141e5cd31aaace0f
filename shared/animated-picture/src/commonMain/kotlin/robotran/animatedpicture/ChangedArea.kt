package robotran.animatedpicture

/** A rectangle of pixels; [right] and [bottom] are the first column and row outside of it. */
data class ChangedArea(val left: Int, val top: Int, val right: Int, val bottom: Int) {
    val width: Int get() = right - left
    val height: Int get() = bottom - top
}

/** The smallest rectangle with all differences between two frames of this [width]; null if they are equal. */
fun changedArea(before: IntArray, after: IntArray, width: Int): ChangedArea? {
    val first = before.indices.firstOrNull { before[it] != after[it] } ?: return null
    val last = before.indices.last { before[it] != after[it] }
    val top = first / width
    val bottom = last / width + 1
    var left = width
    var right = 0
    for (row in top..<bottom) {
        val start = row * width
        for (column in 0..<left) {
            if (before[start + column] != after[start + column]) {
                left = column
                break
            }
        }
        for (column in width - 1 downTo right) {
            if (before[start + column] != after[start + column]) {
                right = column + 1
                break
            }
        }
    }
    return ChangedArea(left, top, right, bottom)
}
