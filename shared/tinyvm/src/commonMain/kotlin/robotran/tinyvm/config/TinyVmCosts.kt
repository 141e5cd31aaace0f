package robotran.tinyvm.config

/**
 * How long a brick computes. The unit is the time of one bytecode. The machine takes every duration from this table.
 *
 * Nobody has published a measurement of leJOS on an RCX. Its `PerformanceTest` shows the time of an empty loop of 10,000
 * rounds; a brick that needs 2.5 seconds for it computes as fast as this table says.
 */
object TinyVmCosts {
    /**
     * Bytecodes in a millisecond. Users estimate 10 to 20. Another interpreter for the same processor, an H8/300 at
     * 16 MHz, was measured at 20 to 35 simpler instructions of 16 bits (elenafrancesco.org, "Firmware Features").
     */
    const val BYTECODES_PER_MILLISECOND = 16

    /**
     * Bytecodes in a millisecond without the speed limit of a brick. A program in an endless loop uses all of them, so
     * more would delay a screen at 60 frames per second.
     */
    const val UNLIMITED_BYTECODES_PER_MILLISECOND = 10_000

    /**
     * What a native method takes beside the bytecode that calls it: nothing, because that bytecode executes it without a
     * frame of its own. Source: leJOS `language.c`, dispatch_special.
     */
    const val NATIVE_METHOD = 0

    /** What a routine of the ROM takes beside the native method that calls it. No source has any duration. */
    const val ROM_ROUTINE = 0

    /**
     * Words of four bytes that are filled, copied or searched in the time of one bytecode. That is the time of a
     * thousand clock cycles, and a word takes about thirty.
     */
    const val WORDS_IN_A_BYTECODE = 32

    /** Stack frames that are searched for an exception handler in the time of one bytecode. An estimate. */
    const val FRAMES_IN_A_BYTECODE = 4
}
