package robotran.blockediting

import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.words.ValueUse

/**
 * The range of a slider for a number. The number pad takes any number.
 *
 * @property step what the buttons beside the number add or subtract.
 */
data class NumberScale(val min: Double, val max: Double, val step: Double)

/** The range that suits what a number is for; null if it is for no number. The sheet is about a metre wide. */
val ValueUse.scale: NumberScale?
    get() = when (this) {
        ValueUse.DISTANCE -> NumberScale(0.0, 100.0, 1.0)
        ValueUse.ANGLE -> NumberScale(0.0, 360.0, 15.0)
        ValueUse.SECONDS -> NumberScale(0.0, 10.0, 0.5)
        ValueUse.MILLISECONDS -> NumberScale(0.0, 2_000.0, 100.0)
        ValueUse.POWER -> RobolangLimits.POWERS.let { NumberScale(it.first.toDouble(), it.last.toDouble(), 1.0) }
        ValueUse.FREQUENCY -> NumberScale(100.0, 2_000.0, 10.0)
        ValueUse.COUNT -> NumberScale(0.0, 20.0, 1.0)
        ValueUse.NUMBER, ValueUse.SHOWN, ValueUse.ANY -> NumberScale(0.0, 100.0, 1.0)
        ValueUse.INDEX -> NumberScale(0.0, 10.0, 1.0)
        ValueUse.CONDITION, ValueUse.LIST -> null
    }
