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

    fun clear() = bits.fill(0)
}
