package robotran.rcxrom

import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdGlyphs
import robotran.rcxrom.display.TextLcd
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class TextLcdTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    private fun shown(text: String): String {
        TextLcd.print(text, hardware.memory)
        hardware.call(RomAddress.REFRESH_LCD)
        return (4 downTo 0).map { LcdGlyphs.read(hardware.lcd.glass.digit(it)) }.joinToString("")
    }

    @Test
    fun `five characters are shown from the left`() {
        assertEquals("HELL0", shown("HELLO"))
        assertEquals("C4   ", shown("C4"))
        assertEquals("AbCdE", shown("abCdEF"))
        assertEquals("     ", shown(""))
    }

    @Test
    fun `nothing is visible before the LCD is refreshed`() {
        TextLcd.print("HELLO", hardware.memory)
        assertEquals(LcdGlass.BLANK, hardware.lcd.glass)
    }

    @Test
    fun `what has no shape is an underscore`() =
        assertEquals("_____", shown("\u0001\u007f\u00e9\u4e16_").replace(' ', '_'))

    private fun showsText(shown: String, wanted: String): Boolean {
        TextLcd.print(shown, hardware.memory)
        hardware.call(RomAddress.REFRESH_LCD)
        return hardware.lcd.glass.shows(wanted)
    }

    @Test
    fun `a text is shown if a reader would say so`() {
        val same = listOf("HELLO" to "hello", "hELLO" to " Hello ", "  GO" to "go", "12" to "12", "HELLOW" to "HELLOES")
        for ((shown, wanted) in same) {
            assertTrue(showsText(shown, wanted), "$shown for $wanted")
        }
        val other = listOf(
            "HELLO" to "HELL",
            "HELL" to "HELLO",
            "HALLO" to "HELLO",
            "" to "HELLO",
            "12" to "120",
            "GO" to "",
        )
        for ((shown, wanted) in other) {
            assertFalse(showsText(shown, wanted), "$shown for $wanted")
        }
        assertTrue(showsText("", ""))
    }

    @Test
    fun `a number is shown whatever zeros it is written with and whatever the program digit is`() {
        hardware.call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, 0, RomCode.LCD_POINT_NONE)

        fun shows(code: Int, number: Int, point: Int, wanted: String): Boolean {
            hardware.call(RomAddress.SET_LCD_NUMBER, code, number, point)
            hardware.call(RomAddress.REFRESH_LCD)
            return hardware.lcd.glass.shows(wanted)
        }
        assertTrue(shows(RomCode.LCD_SIGNED, 12, RomCode.LCD_POINT_NONE, "12"))
        assertTrue(shows(RomCode.LCD_UNSIGNED, 12, RomCode.LCD_POINT_NONE, "12"))
        assertTrue(shows(RomCode.LCD_SIGNED, -12, RomCode.LCD_POINT_NONE, "-12"))
        assertTrue(shows(RomCode.LCD_SIGNED, 150, RomCode.LCD_POINT_2, "1.5"))
        assertTrue(shows(RomCode.LCD_SIGNED, 12, RomCode.LCD_POINT_NONE, "12 0"))
        assertFalse(shows(RomCode.LCD_SIGNED, 12, RomCode.LCD_POINT_NONE, "120"))
        assertFalse(shows(RomCode.LCD_SIGNED, 12, RomCode.LCD_POINT_1, "12"))
        assertFalse(shows(RomCode.LCD_SIGNED, -12, RomCode.LCD_POINT_NONE, "12"))
    }
}
