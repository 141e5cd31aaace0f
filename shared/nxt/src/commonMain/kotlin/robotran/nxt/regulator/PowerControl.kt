package robotran.nxt.regulator

/**
 * The power that brings a motor where it should be, from the error, its sum and its change: the law and figures of
 * leJOS NXJ's firmware, in 32-bit numbers.
 */
internal class PowerControl {
    private var fastError = 0f
    private var slowError = 0f
    private var base = 0f

    /** Forgets what was. */
    fun reset() {
        fastError = 0f
        slowError = 0f
        base = 0f
    }

    /** The power for an [error] in degrees, -100..100. Call it every [MotorRegulator.PERIOD]. */
    fun power(error: Float, isHolding: Boolean): Int {
        fastError = FAST_KEPT * fastError + (1 - FAST_KEPT) * error
        slowError = SLOW_KEPT * slowError + (1 - SLOW_KEPT) * error
        val proportional = if (isHolding) HOLD_P else MOVE_P
        val differential = if (isHolding) HOLD_D else MOVE_D
        val power = base + proportional * fastError + differential * (fastError - slowError)
        base = (base + INTEGRAL * (power - base)).coerceIn(-HIGHEST, HIGHEST)
        return (if (power < 0) power - HALF else power + HALF).coerceIn(-HIGHEST, HIGHEST).toInt()
    }

    private companion object {
        const val FAST_KEPT = 0.375f
        const val SLOW_KEPT = 0.75f
        const val MOVE_P = 6f
        const val MOVE_D = 22f
        const val HOLD_P = 2f
        const val HOLD_D = 8f
        const val INTEGRAL = 0.04f
        const val HIGHEST = 100f
        const val HALF = 0.5f
    }
}
