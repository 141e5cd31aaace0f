package robotran.runcontrol

/**
 * Turns the times of frames into the virtual milliseconds that pass between them. It has no clock: whoever draws the
 * frames says when they come. When more is asked for than can be computed between two frames, they come later; then it
 * asks for less, so that the screen stays alive. Frames that come late because they are drawn slowly would not come
 * sooner for that: how long drawing takes shows itself in a frame for which next to nothing is computed, and there is
 * one now and then.
 */
internal class FramePace {
    private var lastNanoseconds: Long? = null

    /** Virtual nanoseconds that have passed but make no millisecond yet. */
    private var leftOver = 0L
    private var max = FIRST_MAX
    private var wasFull = false
    private var wasTrial = false
    private var fullFrames = 0

    /** Real nanoseconds from frame to frame when next to nothing is computed. */
    private var drawing = 0L

    /** How much of the next millisecond has passed, 0 up to 1. */
    val fraction: Double get() = leftOver.toDouble() / NANOSECONDS

    /**
     * The whole virtual milliseconds to let pass in the frame at [nanoseconds]; 0 in the first one after a [rest]. Of
     * the time since the frame before never more than [LONGEST_FRAME] milliseconds count: a machine that is too slow
     * shows slow motion instead of falling ever further behind.
     */
    fun millisecondsTo(nanoseconds: Long, speed: RunSpeed): Int {
        val last = lastNanoseconds
        lastNanoseconds = nanoseconds
        if (last == null) return 0
        val passed = (nanoseconds - last).coerceAtLeast(0)
        adapt(passed)
        val wanted = wanted(passed, speed)
        wasFull = wanted >= max
        wasTrial = wasFull && fullFrames++ % TRIAL_EVERY == 0
        return if (wasTrial) MAX.first else minOf(wanted, max)
    }

    /** Time stands still until the next frame. */
    fun rest() {
        lastNanoseconds = null
        leftOver = 0
        wasFull = false
        wasTrial = false
    }

    private fun wanted(passed: Long, speed: RunSpeed): Int {
        if (speed == RunSpeed.FASTEST) return max
        val virtual = leftOver + minOf(passed, LONGEST_FRAME * NANOSECONDS) * speed.virtual / speed.real
        leftOver = virtual % NANOSECONDS
        return (virtual / NANOSECONDS).toInt()
    }

    private fun adapt(passed: Long) {
        if (wasTrial) {
            drawing = minOf(passed, MAX_DRAWING * NANOSECONDS)
        } else if (wasFull) {
            max = when {
                passed > maxOf(SLOW_FRAME * NANOSECONDS, drawing * 3 / 2) -> max * 2 / 3
                passed < maxOf(GOOD_FRAME * NANOSECONDS, drawing * 5 / 4) -> max * 3 / 2
                else -> max
            }.coerceIn(MAX)
        }
    }

    private companion object {
        const val NANOSECONDS = 1_000_000L

        /**
         * Real milliseconds: ten frames a second, which is what drawing without a graphics processor may come to, still
         * show real time.
         */
        const val LONGEST_FRAME = 100L

        /** Real milliseconds. */
        const val SLOW_FRAME = 28L
        const val GOOD_FRAME = 20L

        /**
         * Real milliseconds: frames do not come later than one and a half times this because of what is computed for
         * them.
         */
        const val MAX_DRAWING = 70L

        /** One in so many frames that ask for all that can be computed. */
        const val TRIAL_EVERY = 32

        /**
         * Virtual milliseconds in one frame: at least what real time needs on a screen with ten frames a second, and
         * what nobody could follow.
         */
        val MAX = 100..5_000
        const val FIRST_MAX = 100
    }
}
