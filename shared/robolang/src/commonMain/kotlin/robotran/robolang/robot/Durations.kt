package robotran.robolang.robot

import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.TimeUnit

/**
 * The durations of timed statements, in whole milliseconds from 0 to [Int.MAX_VALUE]. Computed in 32-bit floats like on
 * the brick, so that the translated program waits exactly as long.
 */
internal class Durations(robot: RobotTarget) {
    private val millisecondsPerCentimetre = robot.millisecondsPerCentimetre.toFloat()
    private val millisecondsPerDegree = robot.millisecondsPerDegree.toFloat()

    /** Also for driving backwards. */
    fun ofMove(centimetres: NumberValue): Int = positive(centimetres.decimal * millisecondsPerCentimetre)

    /** Also for turning right. */
    fun ofTurn(degrees: NumberValue): Int = positive(degrees.decimal * millisecondsPerDegree)

    fun ofWait(duration: NumberValue, unit: TimeUnit): Int {
        val millisecondsPerUnit = when (unit) {
            TimeUnit.SECONDS -> MILLISECONDS_PER_SECOND
            TimeUnit.MILLISECONDS -> 1
        }
        return when (duration) {
            is NumberValue.Whole -> (duration.value.toLong() * millisecondsPerUnit).coerceIn(
                0L,
                Int.MAX_VALUE.toLong(),
            ).toInt()

            is NumberValue.Decimal -> roundHalfUp(duration.decimal * millisecondsPerUnit).coerceAtLeast(0)
        }
    }

    /** A tone's duration in hundredths of a second; exact for whole seconds. */
    fun ofTone(seconds: NumberValue): Int = when (seconds) {
        is NumberValue.Whole -> (seconds.value.toLong() * TONE_UNITS_PER_SECOND).coerceIn(
            0L,
            Int.MAX_VALUE.toLong(),
        ).toInt()

        is NumberValue.Decimal -> roundHalfUp(seconds.decimal * TONE_UNITS_PER_SECOND).coerceAtLeast(0)
    }

    private fun positive(milliseconds: Float): Int = roundHalfUp(if (milliseconds < 0f) -milliseconds else milliseconds)

    private companion object {
        const val MILLISECONDS_PER_SECOND = 1000
        const val TONE_UNITS_PER_SECOND = 100
    }
}

/** Rounds [value], which is at least 0; halves round up. At most [Int.MAX_VALUE]. */
internal fun roundHalfUp(value: Float): Int {
    val below = value.toInt()
    return if (value - below >= 0.5f && below < Int.MAX_VALUE) below + 1 else below
}
