package robotran.robolang.robot

import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.TimeUnit

/**
 * How long the timed statements last, in whole milliseconds from 0 to [Int.MAX_VALUE]. In 32-bit decimals, because the
 * brick has no others and its translated program is to wait exactly as long.
 */
internal class Durations(calibration: Calibration) {
    private val millisecondsPerCentimetre = calibration.millisecondsPerCentimetre.toFloat()
    private val millisecondsPerDegree = calibration.millisecondsPerDegree.toFloat()

    /** Backwards takes as long as forwards. */
    fun ofMove(centimetres: NumberValue): Int = positive(centimetres.decimal * millisecondsPerCentimetre)

    /** To the right takes as long as to the left. */
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

    /** A tone's hundredths of a second, of which a whole number is exact, too. */
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

/**
 * The whole number nearest to [value], which is 0 or more; the larger one if there are two, and no larger one than
 * there is.
 */
internal fun roundHalfUp(value: Float): Int {
    val below = value.toInt()
    return if (value - below >= 0.5f && below < Int.MAX_VALUE) below + 1 else below
}
