package robotran.legofirmware.device

/**
 * The four timers and the watch.
 *
 * @param now the brick's clock in milliseconds.
 */
internal class Clocks(private val now: () -> Long) {
    private val starts = LongArray(TIMERS)
    private var watchStart = 0L

    fun hasTimer(number: Int): Boolean = number in 0 until TIMERS

    /** In 100 ms; 0 follows 32767. */
    fun timer(number: Int): Int = count(number, SLOW)

    /** The same timer in 10 ms. */
    fun fastTimer(number: Int): Int = count(number, FAST)

    fun setTimer(number: Int, value: Int) {
        starts[number] = now() - value * SLOW
    }

    fun setFastTimer(number: Int, value: Int) {
        starts[number] = now() - value * FAST
    }

    /** Minutes since midnight as set, or since the firmware began. */
    val watch: Int get() = ((now() - watchStart) / MINUTE).mod(DAY).toInt()

    fun setWatch(minutes: Int) {
        watchStart = now() - minutes * MINUTE
    }

    private fun count(number: Int, unit: Long): Int = ((now() - starts[number]) / unit).mod(COUNTS).toInt()

    companion object {
        const val TIMERS = 4
        const val MINUTES_IN_HOUR = 60
        private const val SLOW = 100L
        private const val FAST = 10L
        private const val COUNTS = 32_768L
        private const val MINUTE = 60_000L
        private const val DAY = 1440L
    }
}
