package robotran.nxt.display

/** A picture of [width] by [height] dots; its memory holds at least the rows that these need. */
class Picture(val memory: DisplayMemory, val width: Int, val height: Int) {
    internal fun isBlack(x: Int, y: Int): Boolean = memory[place(x, y)] shr (y and LAST_BIT) and 1 == 1

    internal fun set(x: Int, y: Int, isBlack: Boolean) {
        val place = place(x, y)
        val bit = 1 shl (y and LAST_BIT)
        val old = memory[place]
        memory[place] = if (isBlack) old or bit else old and bit.inv()
    }

    private fun place(x: Int, y: Int) = (y shr ROW_SHIFT) * width + x

    internal companion object {
        const val ROW_SHIFT = 3
        const val LAST_BIT = 7
    }
}

/**
 * Combines a part of a picture with a part of another. Of a dot d of the target and a dot s of the source it makes
 * `(d & s & A) ^ (d & B) ^ (s & C) ^ D`, where A to D are the bytes of [operation] from the highest one, of which the
 * lowest bit counts.
 */
data class BitBlt(
    val sourceX: Int,
    val sourceY: Int,
    val targetX: Int,
    val targetY: Int,
    val width: Int,
    val height: Int,
    val operation: Int,
) {
    /** Draws what lies within both pictures. They may be the same one if both parts are the same. */
    fun draw(source: Picture, target: Picture) {
        val columns = common(sourceX, source.width, targetX, target.width, width)
        val rows = common(sourceY, source.height, targetY, target.height, height)
        for (row in rows) {
            for (column in columns) {
                val x = targetX + column
                val y = targetY + row
                target.set(x, y, combined(target.isBlack(x, y), source.isBlack(sourceX + column, sourceY + row)))
            }
        }
    }

    private fun combined(target: Boolean, source: Boolean): Boolean {
        val index = (if (target) 2 else 0) + (if (source) 1 else 0)
        return outcomes shr index and 1 == 1
    }

    /** Bit `2 d + s` is what becomes of the dots d and s. */
    private val outcomes: Int = run {
        val both = operation ushr BOTH_SHIFT and 1
        val ofTarget = operation ushr TARGET_SHIFT and 1
        val ofSource = operation ushr SOURCE_SHIFT and 1
        val always = operation and 1
        (0..3).sumOf { index ->
            val d = index shr 1
            val s = index and 1
            ((d and s and both) xor (d and ofTarget) xor (s and ofSource) xor always) shl index
        }
    }

    /** The offsets that lie in both pictures. */
    private fun common(sourceAt: Int, sourceSize: Int, targetAt: Int, targetSize: Int, size: Int): IntRange {
        val first = maxOf(0L, -sourceAt.toLong(), -targetAt.toLong())
        val end = minOf(size.toLong(), sourceSize - sourceAt.toLong(), targetSize - targetAt.toLong())
        return if (first >= end) IntRange.EMPTY else first.toInt()..<end.toInt()
    }

    companion object {
        /** The target becomes the source. */
        const val COPY = 0x0000FF00

        /** The target becomes black where the source is. */
        const val OR = 0xFFFFFF00.toInt()

        /** The target becomes its opposite where the source is black. */
        const val XOR = 0x00FFFF00

        /** The target becomes its opposite. */
        const val INVERT = 0x00FF00FF

        private const val BOTH_SHIFT = 24
        private const val TARGET_SHIFT = 16
        private const val SOURCE_SHIFT = 8
    }
}
