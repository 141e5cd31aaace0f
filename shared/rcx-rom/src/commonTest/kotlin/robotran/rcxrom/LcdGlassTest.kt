package robotran.rcxrom

import robotran.language.Language
import robotran.rcxrom.display.Lcd
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.display.LcdLayout
import robotran.rcxrom.display.TextLcd
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.messages.describe
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals

class LcdGlassTest {
    private val memory = RcxMemory()
    private val lcd = Lcd(memory)

    /** The address of each bit of a digit's mask in leJOS TextLCD, from bit 0. */
    private val textLcdPlaces = listOf(
        listOf(0xEF44 to 5, 0xEF45 to 5, 0xEF44 to 4, 0xEF47 to 5, 0xEF47 to 7, 0xEF44 to 7, 0xEF45 to 7),
        listOf(0xEF43 to 5, 0xEF47 to 1, 0xEF43 to 4, 0xEF48 to 5, 0xEF48 to 7, 0xEF43 to 7, 0xEF47 to 3),
        listOf(0xEF44 to 1, 0xEF48 to 1, 0xEF44 to 0, 0xEF49 to 5, 0xEF49 to 7, 0xEF44 to 3, 0xEF48 to 3),
        listOf(0xEF46 to 1, 0xEF4B to 1, 0xEF46 to 0, 0xEF4B to 5, 0xEF4B to 7, 0xEF46 to 3, 0xEF4B to 3),
        listOf(0xEF46 to 5, 0xEF4A to 1, 0xEF46 to 4, 0xEF4A to 5, 0xEF4A to 7, 0xEF46 to 7, 0xEF4A to 3),
    )

    @Test
    fun `every bit written to memory directly is that segment of that digit`() {
        textLcdPlaces.forEachIndexed { position, places ->
            places.forEachIndexed { bit, (address, addressBit) ->
                memory.writeByte(address, 1 shl addressBit)
                val glass = LcdGlass.of(memory)
                assertEquals(List(5) { if (it == position) 1 shl bit else 0 }, List(5, glass::digit))
                assertEquals(emptySet(), glass.litIcons)
                memory.writeByte(address, 0)
            }
        }
    }

    @Test
    fun `no bit of the display is two things and only two are nothing`() {
        val segments =
            LcdLayout.digitSegments.flatten() +
                LcdIcon.entries.filter { it != LcdIcon.WALKING_MAN }.flatMap { it.segments } +
                (LcdIcon.WALKING_MAN.segments - LcdIcon.STANDING_MAN.segments.toSet())
        assertEquals(segments.size, segments.toSet().size)
        assertEquals(70, segments.size)
    }

    @Test
    fun `letters made of segments can be read`() {
        val masks = listOf(0x5B, 0x3D, 0x38, 0x38)
        masks.forEachIndexed { place, mask -> lcd.writeDigit(4 - place, mask) }
        lcd.writeDigit(0, 0x71)
        assertEquals("HELL o", LcdGlass.of(memory).text)
    }

    @Test
    fun `a shape that is no letter is a question mark and blanks between digits stay`() {
        lcd.writeDigit(4, 0x42)
        lcd.writeDigit(2, 0x0A)
        assertEquals("1 ?", LcdGlass.of(memory).text)
    }

    @Test
    fun `a position that is not there is dark`() {
        lcd.lightAll()
        val glass = LcdGlass.of(memory)
        assertEquals(0, glass.digit(-1))
        assertEquals(0, glass.digit(5))
    }

    @Test
    fun `a glass does not change with the memory it was made of`() {
        val before = LcdGlass.of(memory)
        lcd.lightAll()
        assertEquals(LcdGlass.BLANK, before)
        assertEquals("", before.text)
        assertNotEquals(before, LcdGlass.of(memory))
        assertEquals(LcdGlass.of(memory), LcdGlass.of(memory))
    }

    @Test
    fun `everything there is to see can be told in words`() {
        assertEquals(
            "9.0 0, standing man",
            RcxBrick(
                listOf(endlessProgram()),
                messages = BrickMessages.of(Language.ENGLISH),
            ).state.glass.describe(messages = BrickMessages.of(Language.ENGLISH)),
        )
        assertEquals("", LcdGlass.BLANK.describe(messages = BrickMessages.of(Language.ENGLISH)))
        val memory = RcxMemory()
        LcdIcon.LOW_BATTERY.segments.forEach { it.set(memory, on = true) }
        assertEquals("low battery", LcdGlass.of(memory).describe(messages = BrickMessages.of(Language.ENGLISH)))
    }

    @Test
    fun `a text is read as its five characters`() {
        val memory = RcxMemory()
        TextLcd.print("Hallo", memory)
        assertEquals("HALLo", LcdGlass.of(memory).characters)
        TextLcd.print("no", memory)
        assertEquals("no", LcdGlass.of(memory).characters)
        assertEquals("", LcdGlass.BLANK.characters)
    }
}
