package robotran.microbit.hardware

/** A line sensor: tells dark from light by a threshold, which it leaves a little behind before it changes its mind. */
internal class LineReader {
    private var isDark = false

    /** What it measures, 0..100 percent of the light that white paper reflects. */
    var grey = 0
        private set

    /** Whether it is over something dark. */
    val seesDark: Boolean get() = isDark

    fun measure(percent: Int) {
        grey = percent.coerceIn(0, ALL)
        isDark = if (isDark) grey < THRESHOLD + HYSTERESIS else grey < THRESHOLD - HYSTERESIS
    }

    private companion object {
        const val ALL = 100

        /** Set by a screw on a real buggy, in the middle between a white and a black surface. */
        const val THRESHOLD = 45
        const val HYSTERESIS = 3
    }
}
