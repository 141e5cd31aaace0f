package robotran.legofirmware.device

import robotran.legofirmware.model.Assumptions

/** The random numbers of the firmware; the same after each [seed] and the same [stir]. */
internal class RandomNumbers {
    private var state = Assumptions.RANDOM_SEED

    fun seed(seed: Int) {
        state = seed
    }

    /** Makes the numbers of a run depend on the moment at which it starts. */
    fun stir(milliseconds: Long) {
        state += milliseconds.toInt()
    }

    /** 0..[greatest], both inclusive; 0 for a negative one. */
    fun next(greatest: Int): Int {
        state = state * FACTOR + STEP
        val bits = (state ushr LOW_BITS) and Short.MAX_VALUE.toInt()
        return if (greatest <= 0) 0 else (bits * (greatest + 1)) ushr RESULT_BITS
    }

    /** A linear congruential generator, with the numbers of the C standard's example. */
    private companion object {
        const val FACTOR = 1_103_515_245
        const val STEP = 12_345
        const val LOW_BITS = 16
        const val RESULT_BITS = 15
    }
}
