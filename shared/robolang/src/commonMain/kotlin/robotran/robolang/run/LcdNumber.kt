package robotran.robolang.run

import robotran.robolang.robot.roundHalfUp
import robotran.robolang.syntax.NumberValue

/**
 * A number on the LCD.
 *
 * @property digits the number without its point, -32768..32767 as for the ROM; the LCD shows at most 9999.
 * @property decimals the number of digits after the point, 0..3.
 */
internal data class LcdNumber(val digits: Int, val decimals: Int)

/**
 * Converts [value] to the LCD's four digits: a decimal number is rounded to the digits that fit after the point,
 * without trailing zeros, like Java prints it: 2.5 as 2.5, 2.0 as 2.0, 3.14159 as 3.142 and 1234.5 as 1235.
 */
internal fun lcdNumber(value: NumberValue): LcdNumber = when (value) {
    is NumberValue.Whole -> LcdNumber(
        value.value.coerceIn(Short.MIN_VALUE.toInt(), Short.MAX_VALUE.toInt()),
        decimals = 0,
    )

    is NumberValue.Decimal -> lcdNumber(value.decimal)
}

private fun lcdNumber(value: Float): LcdNumber {
    val magnitude = if (value < 0f) -value else value
    var decimals = RobotConstants.LCD_DECIMALS
    var digits = scaled(magnitude, decimals)
    while (digits > RobotConstants.LCD_LARGEST && decimals > 0) {
        decimals--
        digits = scaled(magnitude, decimals)
    }
    while (decimals > 1 && digits % 10 == 0) {
        decimals--
        digits /= 10
    }
    val shown = digits.coerceAtMost(Short.MAX_VALUE.toInt())
    return LcdNumber(if (value < 0f) -shown else shown, decimals)
}

private fun scaled(magnitude: Float, decimals: Int): Int = roundHalfUp(
    (1..decimals).fold(magnitude) { scaled, _ ->
        scaled *
            10f
    },
)
