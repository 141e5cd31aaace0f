package robotran.tinyvm.run

/** The figures of the machine, each with its unit and source. */
internal object MachineConstants {
    /**
     * Bytecodes in one step of the brick, of which it gives two to each millisecond. With 8 a program does 16,000 bytecodes a second: an
     * RCX (H8/300 at 16 MHz) is estimated at 10,000 to 20,000; no measurement is known.
     */
    const val BYTECODES_PER_STEP = 8

    /** How long a thread runs before another of the same priority has its turn, in milliseconds. Source: leJOS, TICKS_PER_TIME_SLICE. */
    const val TIME_SLICE_MILLISECONDS = 20

    /** How often the sensors and buttons are looked at for listeners, in milliseconds. Source: leJOS `sensors.c`. */
    const val POLL_MILLISECONDS = 3

    /**
     * Bytes that a program has for its objects: from 0x8000 to 0xEF31 there are 28 KB, of which leJOS takes 16 to 17 KB. Source: leJOS
     * `main.c`.
     */
    const val BRICK_HEAP_BYTES = 0x3000

    /**
     * Bytes of a thread's first stack: four frames, ten words and three headers. Source: leJOS `configure.h`, INITIAL_STACK_FRAMES and
     * INITIAL_STACK_SIZE, `threads.c`.
     */
    const val BRICK_THREAD_BYTES = 140

    /** Words of the forgiving mode's heap: 1 MB. */
    const val FORGIVING_HEAP_WORDS = 262_144

    /** Of a full heap at least one part in so many must come free, or it counts as full: collecting for less would take all the time. */
    const val LEAST_FREED_PART = 8

    /** Where arrays appear to be in the brick's memory: leJOS keeps programs and objects there. */
    const val FIRST_ARRAY_ADDRESS = 0xC000
    const val LAST_ARRAY_ADDRESS = 0xEF00

    /** A short in the firmware's own part of the memory for the buttons that are pressed. */
    const val BUTTONS_VARIABLE = 0x8002

    const val MAIN_PRIORITY = 5
    const val LEAST_PRIORITY = 1
    const val HIGHEST_PRIORITY = 10

    /** How long a run whose threads all wait for each other rests before it looks again, in milliseconds. */
    const val STANDSTILL_MILLISECONDS = 1000L
}
