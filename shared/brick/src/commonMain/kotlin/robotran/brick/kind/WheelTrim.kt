package robotran.brick.kind

import kotlin.math.floor

/**
 * By what a program slows down the faster wheel of a robot that drives by time, so that it drives straight.
 *
 * @property left the factor for the power of the left wheel, above 0, at most 1; one of both is 1.
 * @property right the same for the right wheel.
 */
data class WheelTrim(val left: Double = 1.0, val right: Double = 1.0) {
    companion object {
        /** Neither wheel is slowed down. */
        val NONE: WheelTrim = WheelTrim()

        private const val HALF = 0.5

        /** A power of [percent] for a wheel with this [factor], whole percents; halves round up. */
        fun percentOf(percent: Int, factor: Double): Int = floor(percent * factor + HALF).toInt()
    }
}
