package robotran.rcxrom.routines

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.Lcd
import robotran.rcxrom.display.LcdGlyphs
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.display.LcdLayout
import robotran.rcxrom.messages.BrickMessages

/** The routines that write numbers to the LCD, clear it and refresh it. */
internal class LcdRoutines(private val lcd: Lcd, private val messages: BrickMessages) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.SET_LCD_NUMBER to ::setNumber,
        RomAddress.CLEAR_LCD to {
            lcd.clear()
            RomEffect(messages.clearDisplay())
        },
        RomAddress.REFRESH_LCD to {
            lcd.refresh()
            RomEffect(messages.refreshDisplay())
        },
    )

    private fun setNumber(arguments: List<Int>): RomEffect {
        val (code, word, pointCode) = arguments
        val signed = word.toShort().toInt()
        return when (code) {
            RomCode.LCD_SIGNED -> setMainNumber(signed, pointCode, leadingZeros = false)
            RomCode.LCD_UNSIGNED -> setMainNumber(word, pointCode, leadingZeros = true)
            RomCode.LCD_PROGRAM -> setProgramDigit(signed)
            else -> refused(messages.unknownCode(code))
        }
    }

    private fun setMainNumber(number: Int, pointCode: Int, leadingZeros: Boolean): RomEffect {
        val pointIsKnown = pointCode in RomCode.LCD_POINT_NONE..RomCode.LCD_POINT_3
        val decimals = if (pointIsKnown) pointCode - RomCode.LCD_POINT_NONE else 0
        val shown = number.coerceIn(-LARGEST, LARGEST)
        val minDigits = if (leadingZeros) MAIN_DIGITS else decimals + 1
        val digits = (if (shown < 0) -shown else shown).toString().padStart(minDigits, '0')

        for (position in 1..MAIN_DIGITS) {
            val digit = digits.getOrNull(digits.length - position)?.let { LcdGlyphs.FIGURES[it - '0'] }
            val minusIsHere = shown < 0 && position == digits.length + 1
            lcd.writeDigit(position, digit ?: if (minusIsHere) LcdGlyphs.MINUS else 0)
        }
        lcd.light(LcdIcon.MINUS, shown < 0 && digits.length == MAIN_DIGITS)
        LcdLayout.POINTS.forEachIndexed { place, point -> lcd.light(point, decimals == place + 1) }

        val text = if (decimals == 0) digits else digits.dropLast(decimals) + "." + digits.takeLast(decimals)
        return RomEffect(
            messages.displayNumber(
                if (shown < 0) "-$text" else text,
                shortened = number.takeIf { it != shown },
                unknownPoint = pointCode.takeIf { !pointIsKnown },
            ),
        )
    }

    private fun setProgramDigit(number: Int): RomEffect {
        if (number !in LcdGlyphs.FIGURES.indices) return RomEffect(messages.programDigitStays(number))
        lcd.writeDigit(position = 0, LcdGlyphs.FIGURES[number])
        return RomEffect(messages.programDigit(number))
    }

    private companion object {
        const val MAIN_DIGITS = 4
        const val LARGEST = 9999
    }
}
