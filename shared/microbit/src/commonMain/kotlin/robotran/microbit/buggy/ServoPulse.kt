package robotran.microbit.buggy

/**
 * The pulses of servos as `write_analog` takes them: a part of 20 ms, 0..1023. A pulse of 1.5 ms is the middle.
 * Source: the extensions of Kitronik for Servo:Lite.
 */
object ServoPulse {
    const val PERIOD_MILLISECONDS = 20

    private const val PERIOD_MICROSECONDS = 20_000
    private const val FULL = 1023
    private const val MIDDLE = 1_500
    private const val SHORTEST = 500
    private const val ANGLES = 180
    private const val ANGLE_MICROSECONDS = 2_000
    private const val ALL = 100

    /** Half a millisecond from the middle a continuous servo turns about as fast as it can. */
    private const val MICROSECONDS_PER_PERCENT = 5

    /** For a continuous servo with -100..100 percent; 0 stops it surely, whatever its trim. */
    fun ofSpeed(percent: Int): Int = if (percent == 0) 0 else of(MIDDLE + MICROSECONDS_PER_PERCENT * percent)

    /** For a servo at an angle of 0..180 degrees. */
    fun ofAngle(degrees: Int): Int = of(SHORTEST + degrees * ANGLE_MICROSECONDS / ANGLES)

    /** The speed that [value] means to a continuous servo, -100..100 percent. */
    fun speedOf(value: Int): Int = if (value == 0) {
        0
    } else {
        ((microseconds(value) - MIDDLE) / MICROSECONDS_PER_PERCENT).coerceIn(-ALL, ALL)
    }

    /** The angle that [value] means to a servo; null if it gets no pulses. */
    fun angleOf(value: Int): Int? =
        if (value == 0) null else ((microseconds(value) - SHORTEST) * ANGLES / ANGLE_MICROSECONDS).coerceIn(0, ANGLES)

    private fun of(microseconds: Int) = (microseconds * FULL + PERIOD_MICROSECONDS / 2) / PERIOD_MICROSECONDS

    private fun microseconds(value: Int) = (value * PERIOD_MICROSECONDS + FULL / 2) / FULL
}
