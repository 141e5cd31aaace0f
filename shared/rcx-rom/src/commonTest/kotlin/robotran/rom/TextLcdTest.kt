package robotran.rom

import kotlin.test.Test
import kotlin.test.assertEquals

class TextLcdTest {
    private val hardware = Hardware()

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
    fun `what has no shape is an underscore`() = assertEquals("_____", shown("\u0001\u007f\u00e9\u4e16_").replace(' ', '_'))
}
