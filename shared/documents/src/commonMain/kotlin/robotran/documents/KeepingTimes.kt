package robotran.documents

/**
 * When a work is to be kept: soon after a change, and at most once in [INTERVAL] milliseconds, so that not even somebody who never stops typing
 * loses more than a second. Times are in milliseconds of any one clock that does not go backwards.
 */
data class KeepingTimes(private val lastBegun: Long? = null) {
    /** Whether a work that has changed is to be kept at [now]. */
    fun isDue(now: Long): Boolean = lastBegun == null || now - lastBegun >= INTERVAL

    /** A copy is being written at [now], however that will end. */
    fun begun(now: Long): KeepingTimes = KeepingTimes(now)

    companion object {
        const val INTERVAL = 500L

        /** How often to look whether something has changed. With [INTERVAL] and the time it takes to write, it stays below a second. */
        const val LOOK = 250L
    }
}
