package robotran.ui.workshop

/** Turns the times of frames into the virtual milliseconds that pass between them. */
internal class FrameClock {
    private var lastNanoseconds: Long? = null
    private var leftOver = 0L

    /**
     * The whole milliseconds since the frame before, never more than [MOST_MILLISECONDS]: a machine that is too slow for real time
     * shows slow motion instead of falling ever further behind.
     */
    fun millisecondsTo(nanoseconds: Long): Int {
        val last = lastNanoseconds
        lastNanoseconds = nanoseconds
        if (last == null) return 0
        val passed = leftOver + (nanoseconds - last).coerceAtLeast(0)
        if (passed > MOST_MILLISECONDS * NANOSECONDS) {
            leftOver = 0
            return MOST_MILLISECONDS
        }
        leftOver = passed % NANOSECONDS
        return (passed / NANOSECONDS).toInt()
    }

    /** Time stands still until the next frame. */
    fun rest() {
        lastNanoseconds = null
        leftOver = 0
    }

    private companion object {
        const val MOST_MILLISECONDS = 50
        const val NANOSECONDS = 1_000_000L
    }
}
