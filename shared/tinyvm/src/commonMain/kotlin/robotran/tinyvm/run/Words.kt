package robotran.tinyvm.run

private const val LOW = 0xFFFFFFFFL

/** The long in two words from index [at] on, the lower one first. */
internal fun longAt(words: IntArray, at: Int): Long =
    (words[at + 1].toLong() shl Int.SIZE_BITS) or (words[at].toLong() and LOW)

internal fun doubleAt(words: IntArray, at: Int): Double = Double.fromBits(longAt(words, at))

/** Puts [value] in two words from index [at] on, the lower one first. */
internal fun setLong(words: IntArray, at: Int, value: Long) {
    words[at] = value.toInt()
    words[at + 1] = (value shr Int.SIZE_BITS).toInt()
}

/** The same for a double; every NaN becomes the same one, so that all platforms have the same bits. */
internal fun setDouble(words: IntArray, at: Int, value: Double) = setLong(words, at, value.toBits())
