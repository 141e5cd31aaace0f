package robotran.robolang.run

/** The random numbers of a brick's class library. */
internal abstract class LejosRandom {
    /** Any whole number. */
    abstract fun next(): Int

    /** A whole number between [first] and [last] inclusive, in either order. */
    fun between(first: Int, last: Int): Int {
        val smaller = minOf(first, last)
        val count = maxOf(first, last) - smaller + 1
        if (count <= 0) return next()
        val rest = next() % count
        return smaller + if (rest < 0) rest + count else rest
    }

    /** A decimal number from [first] to [last]. */
    fun between(first: Float, last: Float): Float = first + (last - first) * ((next() and LOW_BITS) / DIVISOR)

    private companion object {
        /** The number of bits in a float's mantissa. */
        const val LOW_BITS = 0xFFFFFF
        const val DIVISOR = 16777216f
    }
}

/** The random numbers of leJOS's `java.util.Random` for [seed]. */
internal class RcxRandom(private var seed: Int) : LejosRandom() {
    private var previousSeed = 1

    override fun next(): Int {
        val next = (seed * FACTOR) xor previousSeed
        previousSeed = seed
        seed = next
        return next
    }

    private companion object {
        /** Source: leJOS `Random.java`. */
        const val FACTOR = 48271
    }
}

/** The random numbers of leJOS NXJ's `java.util.Random` for a seed: those of any Java. */
internal class NxtRandom(seed: Int) : LejosRandom() {
    private var seed = (seed.toLong() xor FACTOR) and MASK

    override fun next(): Int {
        seed = (seed * FACTOR + ADDEND) and MASK
        return (seed ushr LOW_BITS).toInt()
    }

    private companion object {
        const val FACTOR = 0x5DEECE66DL
        const val ADDEND = 11
        const val MASK = (1L shl 48) - 1
        const val LOW_BITS = 16
    }
}
