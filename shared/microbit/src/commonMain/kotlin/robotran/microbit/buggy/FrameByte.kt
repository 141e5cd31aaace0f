package robotran.microbit.buggy

import kotlin.math.abs

/** A wheel of a buggy. */
enum class WheelSide { LEFT, RIGHT }

/**
 * A byte of what a program writes to the chip of a buggy. As data, so that the interpreter computes it, a translation
 * writes how to compute it, and the simulated chip reads it back.
 */
sealed interface FrameByte {
    /** Always [value], 0..255. */
    data class Fixed(val value: Int) : FrameByte

    /** [ahead] if the wheel of this [side] drives ahead or stands, otherwise [back]. */
    data class Direction(val side: WheelSide, val ahead: Int, val back: Int) : FrameByte

    /** The power of the wheel of this [side] whichever way it drives: 0..[full]. */
    data class Power(val side: WheelSide, val full: Int) : FrameByte

    /** The same if it drives ahead, otherwise 0. */
    data class PowerAhead(val side: WheelSide, val full: Int) : FrameByte

    /** The same if it drives back, otherwise 0. */
    data class PowerBack(val side: WheelSide, val full: Int) : FrameByte

    /** 1 if the left wheel drives back, and 2 more if the right one does. */
    data object BackBits : FrameByte

    /** The angle of a servo, 0..180. */
    data object Angle : FrameByte
}

/** What is written at once to the chip of a buggy. */
data class Frame(val bytes: List<FrameByte>) {
    /** The bytes for wheels with these percents, -100..100. */
    fun of(left: Int, right: Int): List<Int> = bytes.map { byte ->
        fun percent(side: WheelSide) = if (side == WheelSide.LEFT) left else right
        when (byte) {
            is FrameByte.Fixed -> byte.value
            is FrameByte.Direction -> if (percent(byte.side) < 0) byte.back else byte.ahead
            is FrameByte.Power -> scaled(abs(percent(byte.side)), byte.full)
            is FrameByte.PowerAhead -> scaled(maxOf(0, percent(byte.side)), byte.full)
            is FrameByte.PowerBack -> scaled(maxOf(0, -percent(byte.side)), byte.full)
            FrameByte.BackBits -> (if (left < 0) 1 else 0) + (if (right < 0) 2 else 0)
            FrameByte.Angle -> error("A wheel has no angle.")
        }
    }

    /** The bytes for a servo at this angle, 0..180. */
    fun of(angle: Int): List<Int> = bytes.map { byte ->
        when (byte) {
            is FrameByte.Fixed -> byte.value
            FrameByte.Angle -> angle
            else -> error("A servo has no power.")
        }
    }

    /** Whether [written] are such bytes. */
    fun matches(written: List<Int>): Boolean = written.size == bytes.size && bytes.indices.all {
        when (val byte = bytes[it]) {
            is FrameByte.Fixed -> written[it] == byte.value
            is FrameByte.Direction -> written[it] == byte.ahead || written[it] == byte.back
            else -> true
        }
    }

    /** What [written] that [matches] says of a wheel, -100..100 percent; null if nothing. */
    fun percent(side: WheelSide, written: List<Int>): Int? {
        var found: Int? = null
        var isBack = false
        for ((place, byte) in bytes.withIndex()) {
            val value = written[place]
            when {
                byte is FrameByte.Power && byte.side == side -> found = percentOf(value, byte.full)

                byte is FrameByte.PowerAhead && byte.side == side ->
                    found = (found ?: 0) + percentOf(value, byte.full)

                byte is FrameByte.PowerBack && byte.side == side ->
                    found = (found ?: 0) - percentOf(value, byte.full)

                byte is FrameByte.Direction && byte.side == side -> isBack = value == byte.back

                byte is FrameByte.BackBits -> isBack = value and (if (side == WheelSide.LEFT) 1 else 2) != 0
            }
        }
        return found?.let { if (isBack) -it else it }
    }

    /** The angle in [written] that [matches]; null if it has none. */
    fun angle(written: List<Int>): Int? = bytes.indexOf(FrameByte.Angle).takeIf { it >= 0 }?.let(written::get)

    companion object {
        private const val ALL = 100

        /** [percent] of [full], rounded: what a program writes. */
        fun scaled(percent: Int, full: Int): Int = (percent * full + ALL / 2) / ALL

        private fun percentOf(value: Int, full: Int): Int = minOf(ALL, (value * ALL + full / 2) / full)
    }
}
