package robotran.nxt

import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.display.Font5x7
import robotran.nxt.display.NxtDisplay
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class FontTest {
    private val printable = Font5x7.PRINTABLE.map { it.toChar() }

    @Test
    fun `no two letters look the same`() {
        val same = printable.groupBy(::columns).values.filter { it.size > 1 }
        assertEquals(emptyList(), same)
    }

    @Test
    fun `only letters below the line reach the eighth row`() {
        val below = printable.filter { character -> columns(character).any { it shr 7 and 1 == 1 } }
        assertEquals(",_gjpqy", below.joinToString(""))
    }

    @Test
    fun `capital letters and digits are seven dots high`() {
        for (character in ('A'..'Z') + ('0'..'9')) {
            val rows = columns(character).fold(0) { all, column -> all or column }
            assertEquals(0x7F, rows, "$character")
        }
    }

    @Test
    fun `the cell of a letter that the font lacks stays empty`() {
        for (character in listOf('\u0080', 'ä', 'ñ', '€')) {
            assertEquals(listOf(0, 0, 0, 0, 0), columns(character), "$character")
            assertFalse(Font5x7.has(character))
        }
    }

    @Test
    fun `a control character without a sign is a box`() {
        for (character in listOf('\u007f', '\u0000')) {
            assertEquals(listOf(0x7F, 0x41, 0x41, 0x41, 0x7F), columns(character), "$character")
            assertFalse(Font5x7.has(character))
        }
        assertTrue(Font5x7.has('~'))
        assertTrue(Font5x7.has('\u0003'))
    }

    @Test
    fun `the picture has five bytes a character and is new each time`() {
        val bytes = Font5x7.bytes()
        assertEquals(Font5x7.CHARACTERS * DisplaySize.GLYPH_WIDTH, bytes.size)
        assertEquals(columns('A'), List(5) { bytes['A'.code * 5 + it].toInt() and 0xFF })
        bytes.fill(0)
        assertEquals(0x7E, columns('A').first())
    }

    @Test
    fun `the whole font looks as it was drawn`() {
        val memory = ByteArrayMemory(ByteArray(DisplaySize.BYTES))
        printable.chunked(DisplaySize.COLUMNS).forEachIndexed { row, characters ->
            Drawing.drawString(memory, characters.joinToString(""), 0, row)
        }
        Drawing.drawString(memory, "\u0001\u0002\u0003\u0004\u0005\u0006\u0008\r\u007fä", 0, 6)
        assertEquals(displayGoldens.getValue("font.txt"), NxtDisplay.of(memory).toArt())
    }

    private fun columns(character: Char) =
        List(DisplaySize.GLYPH_WIDTH) { Font5x7.columnOf(Font5x7.glyphOf(character), it) }
}
