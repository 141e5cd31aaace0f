package robotran.tinyvm.run

/** The figures of the machine, each with its unit and source. */
internal object VirtualMachineConstants {
    /**
     * How many words are filled, copied or looked at in the time of a bytecode: where one works on many, it takes the
     * time of several.
     */
    const val WORDS_IN_A_BYTECODE = 32

    /**
     * How long a thread runs before another of the same priority has its turn, in milliseconds. Source: leJOS,
     * TICKS_PER_TIME_SLICE.
     */
    const val TIME_SLICE_MILLISECONDS = 20

    /**
     * Bytes of a thread's first stack: four frames, ten words and three headers. Source: leJOS `configure.h`,
     * INITIAL_STACK_FRAMES and INITIAL_STACK_SIZE, `threads.c`.
     */
    const val BRICK_THREAD_BYTES = 140

    /** Words of the forgiving mode's heap: 1 MB. */
    const val FORGIVING_HEAP_WORDS = 262_144

    /**
     * Of a full heap at least one part in so many must come free, or it counts as full: collecting for less would take
     * all the time.
     */
    const val MIN_FREED_PART = 8

    /** Where arrays appear to be in the brick's memory: leJOS keeps programs and objects there. */
    const val FIRST_ARRAY_ADDRESS = 0xC000
    const val LAST_ARRAY_ADDRESS = 0xEF00

    /** How many arrays appear there at the same time. */
    const val SHOWN_ARRAYS = 256

    const val MAIN_PRIORITY = 5
    const val MIN_PRIORITY = 1
    const val HIGHEST_PRIORITY = 10

    /** How long a run whose threads all wait for each other rests before it looks again, in milliseconds. */
    const val STANDSTILL_MILLISECONDS = 1000L
}
