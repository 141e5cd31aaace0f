package robotran.nxt

import robotran.nxt.display.BitBlt
import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.display.Font5x7
import robotran.nxt.display.NxtDisplay
import robotran.nxt.display.Picture
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class DisplayTest {
    private val memory = ByteArrayMemory(ByteArray(DisplaySize.BYTES))
    private val screen = Picture(memory, DisplaySize.WIDTH, DisplaySize.HEIGHT)
    private val font = Picture(ByteArrayMemory(Font5x7.bytes()), Font5x7.CHARACTERS * DisplaySize.GLYPH_WIDTH, 8)
    private val display get() = NxtDisplay.of(memory)

    @Test
    fun `each operation of bitBlt does with two dots what its name says`() {
        val operations = mapOf<Int, (Boolean, Boolean) -> Boolean>(
            0x00000000 to { _, _ -> false },
            0xff000000.toInt() to { d, s -> d && s },
            0xff00ff00.toInt() to { d, s -> s && !d },
            BitBlt.COPY to { _, s -> s },
            0xffff0000.toInt() to { d, s -> d && !s },
            0x00ff0000 to { d, _ -> d },
            BitBlt.XOR to { d, s -> d != s },
            BitBlt.OR to { d, s -> d || s },
            -1 to { d, s -> !(d || s) },
            0x00ffffff to { d, s -> d == s },
            BitBlt.INVERT to { d, _ -> !d },
            0xffff00ff.toInt() to { d, s -> !(d && !s) },
            0x0000ffff to { _, s -> !s },
            0xff00ffff.toInt() to { d, s -> !(s && !d) },
            0xff0000ff.toInt() to { d, s -> !(d && s) },
            0x000000ff to { _, _ -> true },
        )
        for ((operation, combined) in operations) {
            for (d in listOf(false, true)) {
                for (s in listOf(false, true)) {
                    val target = oneDot(d)
                    BitBlt(0, 0, 0, 0, 1, 1, operation).draw(oneDot(s), target)
                    assertEquals(combined(d, s), NxtDisplay.of(target.memory).isBlack(0, 0), "$operation of $d and $s")
                }
            }
        }
    }

    @Test
    fun `a character can be drawn at any dot`() {
        drawCharacter('R', 43, 21)
        Drawing.drawString(memory, "R", 0, 0)
        for (x in 0..4) {
            for (y in 0..7) assertEquals(display.isBlack(x, y), display.isBlack(43 + x, 21 + y), "$x, $y")
        }
    }

    @Test
    fun `what lies beyond an edge of either picture is left out`() {
        drawCharacter('H', -2, -3)
        drawCharacter('H', 98, 60)
        assertTrue(display.isBlack(0, 0))
        assertTrue(display.isBlack(98, 63))
        val before = display
        drawCharacter('H', 100, 0)
        drawCharacter('H', 0, 64)
        BitBlt(638, 0, 40, 0, 50, 50, BitBlt.INVERT).draw(font, screen)
        assertEquals(2 * 8, display.toArt().count { it == '#' } - before.toArt().count { it == '#' })
        BitBlt(0, 0, Int.MAX_VALUE, 0, Int.MAX_VALUE, 8, BitBlt.INVERT).draw(font, screen)
        BitBlt(0, 0, 0, 0, -5, 8, BitBlt.INVERT).draw(font, screen)
    }

    @Test
    fun `a part of a picture can be changed in its place`() {
        Drawing.drawString(memory, "abc", 0, 2)
        BitBlt(0, 16, 0, 16, 100, 8, 0).draw(screen, screen)
        assertTrue(display.isBlank)
    }

    @Test
    fun `text is read back from its dots`() {
        Drawing.drawString(memory, "Speed: 12.5", 1, 3)
        Drawing.drawString(memory, "low!", 12, 3, inverted = true)
        assertEquals(" Speed: 12.5low!", display.lines[3])
        assertEquals(listOf("Speed: 12.5low!"), display.texts)
        screen.memory[3 * 100 + 6] = 0xAA
        assertEquals("?", display.lines[3].trim().take(1))
    }

    @Test
    fun `a black area reads as blanks and a picture as question marks`() {
        BitBlt(0, 0, 0, 0, 100, 8, 0xFF).draw(screen, screen)
        assertEquals("", display.lines[0])
        screen.memory[100] = 0x81
        assertEquals("?", display.lines[1])
    }

    @Test
    fun `the display shows a text or number if a whole line is it`() {
        Drawing.drawString(memory, "  7.50", 0, 0)
        Drawing.drawString(memory, "Hello you", 0, 1)
        assertTrue(display.shows("7.5"))
        assertTrue(display.shows(" Hello you "))
        assertFalse(display.shows("Hello"))
        assertFalse(display.shows("7"))
    }

    @Test
    fun `displays are equal if their dots are`() {
        Drawing.drawString(memory, "x", 0, 0)
        val one = display
        assertEquals(one, display)
        assertEquals(one.hashCode(), display.hashCode())
        Drawing.clear(memory)
        assertNotEquals(one, display)
        assertEquals(NxtDisplay.BLANK, display)
    }

    @Test
    fun `there is no dot beyond the edge`() {
        BitBlt(0, 0, 0, 0, 100, 64, 0xFF).draw(screen, screen)
        for ((x, y) in listOf(-1 to 0, 100 to 0, 0 to -1, 0 to 64)) assertFalse(display.isBlack(x, y))
        assertTrue(display.isBlack(99, 63))
    }

    private fun drawCharacter(character: Char, x: Int, y: Int) =
        BitBlt(character.code * 5, 0, x, y, 5, 8, BitBlt.COPY).draw(font, screen)

    private fun oneDot(isBlack: Boolean) =
        Picture(ByteArrayMemory(ByteArray(DisplaySize.BYTES).also { it[0] = if (isBlack) 1 else 0 }), 1, 1)
}
