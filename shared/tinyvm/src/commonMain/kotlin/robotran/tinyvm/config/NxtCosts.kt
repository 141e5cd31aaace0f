package robotran.tinyvm.config

/**
 * How long an NXT computes. The unit is the time of one bytecode. The machine takes every duration from this table.
 *
 * Nobody has published a measurement of leJOS NXJ. The processor runs at 48 MHz from flash. The firmware regulates three
 * motors every 4 ms in Java with time left, at about 340 bytecodes a motor, so it does more than 255 in a millisecond.
 */
object NxtCosts {
    /** Bytecodes in a millisecond. An estimate; 200 to 500 are possible. */
    const val BYTECODES_PER_MILLISECOND = 300

    /** Bytecodes in a millisecond without the speed limit of a brick. */
    const val UNLIMITED_BYTECODES_PER_MILLISECOND = 10_000

    /** Steps of the brick in a millisecond. */
    const val STEPS_PER_MILLISECOND = 30

    /** Milliseconds that a thread runs before another of the same priority. */
    const val SLICE_MILLISECONDS = 2

    /** What a native method takes beside the bytecode that calls it, unless it says more. */
    const val NATIVE_METHOD = 1

    /** What a native method takes that sets something. */
    const val SETTING = 2
    const val I2C_ENABLE = 4
    const val I2C_START = 5

    /** In leJOS NXJ, Java asks a colour sensor bit by bit. */
    const val READ_COLOUR = 30
    const val CLEAR_DISPLAY = 8
    const val DRAW_NUMBER = 12
    const val DRAW_TEXT = 4
    const val DRAW_CHARACTER = 2
    const val DRAW_PICTURE = 8

    /** Dots of a picture that are drawn in the time of one bytecode. */
    const val DOTS_IN_A_BYTECODE = 32

    /** Words of four bytes that are filled, copied or searched in the time of one bytecode. */
    const val WORDS_IN_A_BYTECODE = 16

    /** Words of living objects that the collector visits in the time of one bytecode. */
    const val COLLECTED_WORDS_IN_A_BYTECODE = 64

    /** Threads among which the next one is chosen in the time of one bytecode. */
    const val THREADS_IN_A_BYTECODE = 8

    /** What each call in a stack trace takes. */
    const val STACK_TRACE_CALL = 4

    /** What operations take beyond one bytecode: the processor has no instructions for them. Estimates. */
    const val DECIMAL_64 = 1
    const val DECIMAL_64_DIVISION = 5
    const val WHOLE_64_DIVISION = 4
}
