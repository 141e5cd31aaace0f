package robotran.hublink

/**
 * What a hub tells about itself at every change.
 *
 * @property program the program that runs, or ran last: a slot, or a number from 128 on for a built-in one.
 * @property slot the slot that is chosen.
 */
data class HubStatus(val flags: Long, val program: Int = 0, val slot: Int = 0) {
    val isBatteryLow: Boolean get() = has(BATTERY_LOW) || has(BATTERY_SHUTDOWN)

    val isProgramRunning: Boolean get() = has(PROGRAM_RUNNING)

    /** Whether the hub is about to switch itself off. */
    val isShuttingDown: Boolean get() = has(SHUTDOWN) || has(SHUTDOWN_REQUESTED) || has(TOO_HOT)

    val isDownloadOpen: Boolean get() = has(DOWNLOAD_OPEN)

    private fun has(bit: Int) = flags shr bit and 1L != 0L

    internal companion object {
        const val BATTERY_LOW = 0
        const val BATTERY_SHUTDOWN = 1
        const val PROGRAM_RUNNING = 6
        const val SHUTDOWN = 7
        const val SHUTDOWN_REQUESTED = 8
        const val TOO_HOT = 10

        /** Comes and goes in each download, from profile 1.5 on. */
        const val DOWNLOAD_OPEN = 13
    }
}
