package robotran.robolang.run

/** The random numbers of `java.util.Random` for [seed], in leJOS on an RCX and in leJOS NXJ on an NXT. */
internal class LejosRandom(private var seed: Int) {
    private var previousSeed = 1

    /** Any whole number. */
    fun next(): Int {
        val next = (seed * FACTOR) xor previousSeed
        previousSeed = seed
        seed = next
        return next
    }

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
        /** Source: leJOS `Random.java`. */
        const val FACTOR = 48271

        /** The number of bits in a float's mantissa. */
        const val LOW_BITS = 0xFFFFFF
        const val DIVISOR = 16777216f
    }
}
