package robotran.tinyvm.run

/** A set of numbers from 0 until [size], one bit each. */
internal class BitSet(size: Int) {
    private val bits = IntArray((size + 31) / 32)

    operator fun get(index: Int): Boolean = bits[index ushr 5] and (1 shl index) != 0

    fun set(index: Int) {
        bits[index ushr 5] = bits[index ushr 5] or (1 shl index)
    }

    fun remove(index: Int) {
        bits[index ushr 5] = bits[index ushr 5] and (1 shl index).inv()
    }

    /** The first number from [from] on that is in the set, -1 if there is none. */
    fun next(from: Int): Int {
        var word = from ushr 5
        if (word >= bits.size) return -1
        var rest = bits[word] and (-1 shl from)
        while (rest == 0) {
            if (++word == bits.size) return -1
            rest = bits[word]
        }
        return (word shl 5) + rest.countTrailingZeroBits()
    }

    fun clear() = bits.fill(0)
}
