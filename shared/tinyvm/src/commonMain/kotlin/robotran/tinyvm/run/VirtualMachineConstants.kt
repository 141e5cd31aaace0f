package robotran.tinyvm.run

/** Constants of the virtual machine, each with its unit and source. */
internal object VirtualMachineConstants {
    /**
     * A collection must leave at least one part in this many of the heap free, or the heap counts as full. Collecting
     * for less would take all the time.
     */
    const val MIN_FREED_PART = 8

    /** The brick addresses at which arrays appear; leJOS keeps programs and objects there. */
    const val FIRST_ARRAY_ADDRESS = 0xC000
    const val LAST_ARRAY_ADDRESS = 0xEF00

    /** Max arrays that have an address at the same time. */
    const val MAX_MAPPED_ARRAYS = 256

    const val MAIN_PRIORITY = 5
    const val MIN_PRIORITY = 1
    const val MAX_PRIORITY = 10

    /** What a thread object says while the thread lives, or after its end. Source: leJOS `threads.h`. */
    const val THREAD_STARTED = 2
    const val THREAD_DEAD = 1

    /** Milliseconds until the next check of a run whose threads all wait for each other. */
    const val STANDSTILL_MILLISECONDS = 1000L
}
