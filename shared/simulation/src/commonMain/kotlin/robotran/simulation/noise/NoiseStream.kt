package robotran.simulation.noise

import kotlin.math.sqrt

/**
 * An endless row of random numbers that is the same wherever it is made. Each cause of chance has a stream of its own,
 * known by a name, so that a new cause, or one that draws more often, leaves the numbers of all others as they are.
 *
 * The numbers are those of SplitMix64 (Steele, Lea and Flood, 2014), begun at a hash of seed and name.
 */
internal class NoiseStream(seed: Int, name: String) {
    private var state = name.fold(mixed(seed.toLong() + GOLDEN_GAMMA)) { hash, character ->
        mixed(hash xor character.code.toLong())
    }

    private fun next(): Long {
        state += GOLDEN_GAMMA
        return mixed(state)
    }

    /** A number from 0 up to, but not including, 1. */
    fun share(): Double = (next() ushr UNUSED_BITS) * SMALLEST_SHARE

    /**
     * A number about 0 with a standard deviation of 1, never beyond 3.5: the sum of four even ones, which is close to
     * the bell curve and, other than logarithms, comes out the same everywhere.
     */
    fun normal(): Double {
        var bits = next()
        var sum = 0L
        repeat(SUMMANDS) {
            sum += bits and SUMMAND_MASK
            bits = bits ushr SUMMAND_BITS
        }
        return (sum - MEAN_SUM) * NORMAL_SCALE
    }

    private companion object {
        const val GOLDEN_GAMMA = -0x61c8864680b583ebL
        const val FIRST_FACTOR = -0x40a7b892e31b1a47L
        const val SECOND_FACTOR = -0x6b2fb644ecceee15L
        const val UNUSED_BITS = 11
        const val SMALLEST_SHARE = 1.0 / (1L shl 53)
        const val SUMMANDS = 4
        const val SUMMAND_BITS = 16
        const val SUMMAND_MASK = 0xFFFFL
        const val MEAN_SUM = SUMMANDS * SUMMAND_MASK / 2.0

        /** Four even numbers from 0 to 65535 have together the variance 4 * 65536^2 / 12. */
        val NORMAL_SCALE = sqrt(12.0 / SUMMANDS) / (SUMMAND_MASK + 1)

        fun mixed(number: Long): Long {
            var mixed = (number xor (number ushr 30)) * FIRST_FACTOR
            mixed = (mixed xor (mixed ushr 27)) * SECOND_FACTOR
            return mixed xor (mixed ushr 31)
        }
    }
}

/** The [NoiseStream]s of one robot. */
internal class NoiseStreams(private val seed: Int, private val robot: Int) {
    fun named(name: String) = NoiseStream(seed, "robot $robot: $name")
}
