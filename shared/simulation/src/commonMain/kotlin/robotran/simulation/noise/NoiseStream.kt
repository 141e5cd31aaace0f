package robotran.simulation.noise

import kotlin.math.sqrt

/**
 * An infinite sequence of random numbers, the same on every platform. Each cause of chance has its own named stream. A
 * new cause, or one that draws more often, does not affect the numbers of the others.
 *
 * The generator is SplitMix64 (Steele, Lea and Flood, 2014), seeded with a hash of seed and name.
 */
internal class NoiseStream(seed: Int, name: String) {
    private var state = name.fold(mixed(seed.toLong() + GOLDEN_GAMMA)) { hash, character ->
        mixed(hash xor character.code.toLong())
    }

    private fun next(): Long {
        state += GOLDEN_GAMMA
        return mixed(state)
    }

    /** A number in [0, 1). */
    fun share(): Double = (next() ushr UNUSED_BITS) * SMALLEST_SHARE

    /**
     * A number with mean 0 and standard deviation 1, never beyond 3.5: the sum of four uniform numbers. This is close
     * to the normal distribution and, unlike logarithms, gives the same result on every platform.
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

        /** The sum of four uniform numbers from 0 to 65535 has the variance 4 * 65536^2 / 12. */
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
