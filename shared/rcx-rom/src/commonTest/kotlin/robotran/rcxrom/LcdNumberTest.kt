package robotran.rcxrom

import robotran.brick.log.CallOutcome
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class LcdNumberTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `signed numbers are shown without leading zeros and with the minus sign beside them`() {
        for (number in listOf(0, 5, 42, 999, 9999, -1, -42, -999, -9999)) {
            assertEquals(number.toString(), hardware.show(RomCode.LCD_SIGNED, number))
        }
    }

    @Test
    fun `signed numbers too long for four digits become the nearest that fits`() {
        assertEquals("9999", hardware.show(RomCode.LCD_SIGNED, 10_000))
        assertEquals("9999", hardware.show(RomCode.LCD_SIGNED, 32_767))
        assertEquals("-9999", hardware.show(RomCode.LCD_SIGNED, -10_000))
        assertEquals("-9999", hardware.show(RomCode.LCD_SIGNED, -32_768))
    }

    @Test
    fun `unsigned numbers have four digits and count negative ones as large`() {
        val shown = mapOf(
            0 to "0000",
            7 to "0007",
            1234 to "1234",
            9999 to "9999",
            10_000 to "9999",
            -1 to "9999",
            40_000 to "9999",
        )
        shown.forEach { (number, text) -> assertEquals(text, hardware.show(RomCode.LCD_UNSIGNED, number)) }
    }

    @Test
    fun `digits up to the decimal point are always shown`() {
        val points = listOf(RomCode.LCD_POINT_NONE, RomCode.LCD_POINT_1, RomCode.LCD_POINT_2, RomCode.LCD_POINT_3)
        val shown = mapOf(
            0 to listOf("0", "0.0", "0.00", "0.000"),
            5 to listOf("5", "0.5", "0.05", "0.005"),
            90 to listOf("90", "9.0", "0.90", "0.090"),
            1234 to listOf("1234", "123.4", "12.34", "1.234"),
            -5 to listOf("-5", "-0.5", "-0.05", "-0.005"),
            -1234 to listOf("-1234", "-123.4", "-12.34", "-1.234"),
        )
        for ((number, texts) in shown) {
            points.zip(texts).forEach { (point, text) ->
                assertEquals(text, hardware.show(RomCode.LCD_SIGNED, number, point))
            }
        }
        assertEquals("000.5", hardware.show(RomCode.LCD_UNSIGNED, 5, RomCode.LCD_POINT_1))
    }

    @Test
    fun `a shorter number leaves nothing of the longer one before it`() {
        hardware.show(RomCode.LCD_SIGNED, -8888, RomCode.LCD_POINT_3)
        assertEquals("1", hardware.show(RomCode.LCD_SIGNED, 1))
        hardware.show(RomCode.LCD_SIGNED, -88, RomCode.LCD_POINT_1)
        assertEquals("-1", hardware.show(RomCode.LCD_SIGNED, -1))
    }

    @Test
    fun `the minus sign has its own segment only beside four digits`() {
        hardware.show(RomCode.LCD_SIGNED, -1234)
        assertEquals(0x40, hardware.memory.readByte(0xEF4A) and 0x40)
        hardware.show(RomCode.LCD_SIGNED, -123)
        assertEquals(0, hardware.memory.readByte(0xEF4A) and 0x40)
        assertEquals(0x01, hardware.lcd.glass.digit(4))
    }

    @Test
    fun `the program digit stands beside the number and touches none of its segments`() {
        hardware.show(RomCode.LCD_SIGNED, 42)
        for (digit in 0..9) {
            hardware.show(RomCode.LCD_PROGRAM, digit)
            assertEquals("42 $digit", hardware.lcd.glass.text)
            assertEquals("$digit", hardware.lcd.glass.programDigit)
        }
    }

    @Test
    fun `a program digit that is none leaves the display`() {
        hardware.show(RomCode.LCD_PROGRAM, 3)
        for (number in listOf(10, -1, 999)) {
            hardware.show(RomCode.LCD_PROGRAM, number)
            assertEquals("3", hardware.lcd.glass.programDigit)
            assertEquals(
                "LCD program digit stays, for $number is none",
                hardware.number(RomCode.LCD_PROGRAM, number).meaning,
            )
        }
    }

    @Test
    fun `numbers leave the icons alone`() {
        hardware.call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_ALL)
        hardware.show(RomCode.LCD_SIGNED, 0)
        hardware.show(RomCode.LCD_PROGRAM, 0)
        val own = setOf(LcdIcon.MINUS, LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)
        assertEquals(LcdIcon.entries.toSet() - own, hardware.lcd.glass.litIcons)
    }

    @Test
    fun `the log tells what is shown and why it is not what was asked for`() {
        assertEquals("0 0x1ff2 0x3001 42 0x3002 ; LCD number 42 ; 7", hardware.number(RomCode.LCD_SIGNED, 42).text)
        assertEquals("LCD number -0.5", hardware.number(RomCode.LCD_SIGNED, -5, RomCode.LCD_POINT_1).meaning)
        assertEquals(
            "0 0x1ff2 0x301f 5000 0x3002 ; LCD number 5000 ; 7",
            hardware.number(RomCode.LCD_UNSIGNED, 5000).text,
        )
        assertEquals("LCD number 9999, for 12000 is too long", hardware.number(RomCode.LCD_SIGNED, 12_000).meaning)
        assertEquals(
            "LCD number 3, without a point, for there is no code 0x3006",
            hardware.number(RomCode.LCD_SIGNED, 3, 0x3006).meaning,
        )
    }

    @Test
    fun `an unknown way to show a number is reported and shows nothing`() {
        val entry = hardware.number(0x3000, 42)
        hardware.lcd.refresh()
        assertEquals(CallOutcome.WRONG_ARGUMENTS, entry.outcome)
        assertEquals(LcdGlass.BLANK, hardware.lcd.glass)
    }

    @Test
    fun `nothing is visible before the refresh and what is visible stays until the next`() {
        hardware.number(RomCode.LCD_SIGNED, 42)
        assertEquals("", hardware.lcd.glass.text)
        assertEquals("0 0x27c8 ; refresh the LCD ; 7", hardware.call(RomAddress.REFRESH_LCD).text)
        assertEquals("42", hardware.lcd.glass.text)
        assertEquals("0 0x27ac ; clear the LCD ; 7", hardware.call(RomAddress.CLEAR_LCD).text)
        assertEquals("42", hardware.lcd.glass.text)
        assertTrue((0xEF43..0xEF4C).all { hardware.memory.readByte(it) == 0 })
        hardware.call(RomAddress.REFRESH_LCD)
        assertEquals(LcdGlass.BLANK, hardware.lcd.glass)
    }

    @Test
    fun `clearing the display leaves the bytes around it`() {
        for (address in 0xEF40..0xEF50) hardware.memory.writeByte(address, 0xFF)
        hardware.call(RomAddress.CLEAR_LCD)
        assertEquals((0xEF43..0xEF4C).toList(), (0xEF40..0xEF50).filter { hardware.memory.readByte(it) == 0 })
    }

    private fun Hardware.number(code: Int, number: Int, point: Int = RomCode.LCD_POINT_NONE) =
        call(RomAddress.SET_LCD_NUMBER, code, number, point)

    private fun Hardware.show(code: Int, number: Int, point: Int = RomCode.LCD_POINT_NONE): String {
        number(code, number, point)
        call(RomAddress.REFRESH_LCD)
        return lcd.glass.number
    }
}
