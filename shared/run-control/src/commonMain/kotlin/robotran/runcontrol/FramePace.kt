package robotran.runcontrol

/**
 * Converts frame times into the virtual milliseconds between frames. It has no clock: the caller passes the frame
 * times. If the computation cannot keep up, frames arrive later; then this asks for less virtual time, so that the
 * screen stays responsive. Frames that are late because drawing is slow would not get faster by this. To measure the
 * drawing time alone, it occasionally computes next to nothing for a frame.
 */
internal class FramePace {
    private var lastNanoseconds: Long? = null

    /** Virtual nanoseconds that have passed but do not make a full millisecond yet. */
    private var leftOver = 0L
    private var max = FIRST_MAX
    private var wasFull = false
    private var wasTrial = false
    private var fullFrames = 0

    /** Real nanoseconds per frame when next to nothing is computed. */
    private var drawing = 0L

    /** The elapsed part of the next millisecond, in [0, 1). */
    val fraction: Double get() = leftOver.toDouble() / NANOSECONDS

    /**
     * The virtual milliseconds to advance in the frame at [nanoseconds]; 0 in the first frame after a [pauseClock]. At most
     * [LONGEST_FRAME] milliseconds since the last frame count: a slow computer shows slow motion instead of falling
     * behind more and more.
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

    /** Stops time until the next frame. */
    fun pauseClock() {
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

        /** Real milliseconds: at ten frames a second, a possible rate without a GPU, time still runs at full speed. */
        const val LONGEST_FRAME = 100L

        /** Real milliseconds. */
        const val SLOW_FRAME = 28L
        const val GOOD_FRAME = 20L

        /** Max real milliseconds for drawing; the computation extends a frame to at most one and a half times this. */
        const val MAX_DRAWING = 70L

        /** One in this many frames at the computation limit measures the drawing time. */
        const val TRIAL_EVERY = 32

        /**
         * Virtual milliseconds in one frame, from what real time needs at ten frames a second to more than the eye can
         * follow.
         */
        val MAX = 100..5_000
        const val FIRST_MAX = 100
    }
}
