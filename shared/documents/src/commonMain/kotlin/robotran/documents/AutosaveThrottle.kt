package robotran.documents

/**
 * Decides when to autosave a project: soon after a change, and at most once in [INTERVAL] milliseconds, so that even
 * continuous typing loses at most a second. A project that takes noticeably long to save is saved when the user pauses,
 * and at the latest every [LONGEST] milliseconds. Times are in milliseconds of a monotonic clock.
 *
 * @property took duration of the last save.
 */
data class AutosaveThrottle(
    private val lastBegun: Long? = null,
    private val took: Long = 0,
    private val lastChange: Long = 0,
) {
    /** Whether a changed project must be saved at [now]. */
    fun isDue(now: Long): Boolean {
        val passed = now - (lastBegun ?: return true)
        if (took <= UNNOTICED) return passed >= INTERVAL
        return passed >= LONGEST || (passed >= took * REST_FOR_EACH && now - lastChange >= REST)
    }

    /** Records a change at [now]. */
    fun changed(now: Long): AutosaveThrottle = copy(lastChange = now)

    /** Records the start of a save at [now]. */
    fun begun(now: Long): AutosaveThrottle = copy(lastBegun = now)

    /** Records the end of the last save at [now], successful or not. */
    fun ended(now: Long): AutosaveThrottle = copy(took = now - (lastBegun ?: now))

    companion object {
        const val INTERVAL = 500L

        /**
         * Interval between checks for changes. With [INTERVAL] and the time for writing, the total stays below a
         * second.
         */
        const val LOOK = 250L

        /** Max duration of a save that the user does not notice while typing. */
        const val UNNOTICED = 50L

        /** Min pause before a long project is saved. */
        const val REST = 1_000L

        /** Max time between two saves, even of a long project during typing. */
        const val LONGEST = 10_000L

        /** Min time between two saves of a long project, as a multiple of the duration of a save. */
        private const val REST_FOR_EACH = 10
    }
}
