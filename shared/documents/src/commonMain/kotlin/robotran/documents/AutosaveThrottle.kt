package robotran.documents

/**
 * When a work is to be kept: soon after a change, and at most once in [INTERVAL] milliseconds, so that not even
 * somebody who never stops typing loses more than a second. A work so long that keeping it can be felt is kept when the
 * keys rest, and every [LONGEST] milliseconds at the latest. Times are in milliseconds of any one clock that does not
 * go backwards.
 *
 * @property took how long it took to keep the last copy.
 */
data class AutosaveThrottle(
    private val lastBegun: Long? = null,
    private val took: Long = 0,
    private val lastChange: Long = 0,
) {
    /** Whether a work that has changed is to be kept at [now]. */
    fun isDue(now: Long): Boolean {
        val passed = now - (lastBegun ?: return true)
        if (took <= UNFELT) return passed >= INTERVAL
        return passed >= LONGEST || (passed >= took * REST_FOR_EACH && now - lastChange >= REST)
    }

    /** Somebody has done something at [now]. */
    fun changed(now: Long): AutosaveThrottle = copy(lastChange = now)

    /** A copy is being written at [now], however that will end. */
    fun begun(now: Long): AutosaveThrottle = copy(lastBegun = now)

    /** The copy that was begun last is written, or cannot be, at [now]. */
    fun ended(now: Long): AutosaveThrottle = copy(took = now - (lastBegun ?: now))

    companion object {
        const val INTERVAL = 500L

        /**
         * How often to look whether something has changed. With [INTERVAL] and the time it takes to write, it stays
         * below a second.
         */
        const val LOOK = 250L

        /** How long keeping may take so that nobody feels it while typing. */
        const val UNFELT = 50L

        /** How long nobody must have done anything before a long work is kept. */
        const val REST = 1_000L

        /** After so long even a long work is kept while somebody types. */
        const val LONGEST = 10_000L

        /** How many times as long as it takes a long work is left alone afterwards. */
        private const val REST_FOR_EACH = 10
    }
}
