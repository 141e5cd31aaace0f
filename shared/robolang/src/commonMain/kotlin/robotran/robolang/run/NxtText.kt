package robotran.robolang.run

import robotran.robolang.robot.roundHalfUp
import robotran.robolang.syntax.NumberValue

/**
 * [value] as the display of an NXT shows it: a whole number as it is, a decimal one with one to three digits behind its
 * point, none if it has more than seven digits. The translation's method `show` works it out in the same way.
 */
internal fun nxtText(value: NumberValue): String = when (value) {
    is NumberValue.Whole -> value.value.toString()
    is NumberValue.Decimal -> nxtText(value.decimal)
}

private fun nxtText(value: Float): String {
    val magnitude = if (value < 0f) -value else value
    var decimals = RobotConstants.LCD_DECIMALS
    var digits = scaled(magnitude, decimals)
    while (digits > LARGEST && decimals > 0) {
        decimals--
        digits = scaled(magnitude, decimals)
    }
    while (decimals > 1 && digits % 10 == 0) {
        decimals--
        digits /= 10
    }
    val text = digits.toString().padStart(decimals + 1, '0')
    val shown = if (decimals == 0) text else text.dropLast(decimals) + "." + text.takeLast(decimals)
    return if (value < 0f) "-$shown" else shown
}

private fun scaled(magnitude: Float, decimals: Int): Int =
    roundHalfUp((1..decimals).fold(magnitude) { scaled, _ -> scaled * 10f })

private const val LARGEST = 9_999_999
