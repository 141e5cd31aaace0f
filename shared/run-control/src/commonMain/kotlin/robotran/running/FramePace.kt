package robotran.running

/**
 * Turns the times of frames into the virtual milliseconds that pass between them. It has no clock: whoever draws the frames says when they come. When
 * more is asked for than can be computed between two frames, they come later; then it asks for less, so that the screen stays alive.
 */
internal class FramePace {
    private var lastNanoseconds: Long? = null

    /** Virtual nanoseconds that have passed but make no millisecond yet. */
    private var leftOver = 0L
    private var most = FIRST_MOST
    private var wasFull = false

    /** How much of the next millisecond has passed, 0 up to 1. */
    val fraction: Double get() = leftOver.toDouble() / NANOSECONDS

    /**
     * The whole virtual milliseconds to let pass in the frame at [nanoseconds]; 0 in the first one after a [rest]. Of the time since the frame before never
     * more than [LONGEST_FRAME] milliseconds count: a machine that is too slow shows slow motion instead of falling ever further behind.
     */
    fun millisecondsTo(nanoseconds: Long, speed: RunSpeed): Int {
        val last = lastNanoseconds
        lastNanoseconds = nanoseconds
        if (last == null) return 0
        val passed = (nanoseconds - last).coerceAtLeast(0)
        adapt(passed)
        val wanted = wanted(passed, speed)
        wasFull = wanted >= most
        return minOf(wanted, most)
    }

    /** Time stands still until the next frame. */
    fun rest() {
        lastNanoseconds = null
        leftOver = 0
        wasFull = false
    }

    private fun wanted(passed: Long, speed: RunSpeed): Int {
        if (speed == RunSpeed.FASTEST) return most
        val virtual = leftOver + minOf(passed, LONGEST_FRAME * NANOSECONDS) * speed.virtual / speed.real
        leftOver = virtual % NANOSECONDS
        return (virtual / NANOSECONDS).toInt()
    }

    private fun adapt(passed: Long) {
        if (!wasFull) return
        most = if (passed > SLOW_FRAME * NANOSECONDS) {
            most * 2 / 3
        } else if (passed < GOOD_FRAME * NANOSECONDS) {
            most * 3 / 2
        } else {
            most
        }
        most = most.coerceIn(MOST)
    }

    private companion object {
        const val NANOSECONDS = 1_000_000L

        /** Real milliseconds. */
        const val LONGEST_FRAME = 50L
        const val SLOW_FRAME = 28L
        const val GOOD_FRAME = 20L

        /** Virtual milliseconds in one frame: at least what real time needs on a screen with ten frames a second, and what nobody could follow. */
        val MOST = 50..5_000
        const val FIRST_MOST = 100
    }
}
