package robotran.microbit

import robotran.microbit.display.BoardDisplay
import robotran.microbit.display.BoardScreen
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class BoardDisplayTest {
    private val display = BoardDisplay()

    @Test
    fun `one character is shown at once`() {
        assertTrue(display.show("1"))
        assertEquals("..#..\n.##..\n..#..\n..#..\n.###.\n", display.screen.toArt())
        assertEquals("1", display.screen.shown)
        assertFalse(display.show("12"))
        assertFalse(display.show("ä"))
        assertEquals("1", display.screen.shown)
    }

    @Test
    fun `a text runs over the lights from the right, a column each 150 milliseconds`() {
        display.scroll("1")
        assertEquals("1", display.screen.shown)
        display.tick(149)
        assertEquals(".....\n.....\n.....\n.....\n.....\n", display.screen.toArt())
        display.tick(2 * 150)
        // The first three columns of the 1 have come in, of which the first is dark.
        assertEquals("....#\n...##\n....#\n....#\n...##\n", display.screen.toArt())
        display.tick(4 * 150)
        assertEquals("..#..\n.##..\n..#..\n..#..\n.###.\n", display.screen.toArt())
        display.tick(11 * 150 - 1)
        assertEquals("1", display.screen.shown)
        display.tick(11 * 150)
        assertEquals(BoardScreen(), display.screen)
    }

    @Test
    fun `what comes later takes the place of a text that runs`() {
        display.scroll("LONG")
        display.tick(500)
        display.show("X")
        display.tick(900)
        assertEquals("X", display.screen.shown)
        display.clear()
        assertEquals(BoardScreen.DARK, display.screen.lights)
    }

    @Test
    fun `the newest lines of output are kept, and found as shown`() {
        repeat(250) { display.print("$it") }
        assertEquals(200, display.screen.printed.size)
        assertTrue(display.screen.shows("249"))
        assertTrue(display.screen.shows("249.0"))
        assertFalse(display.screen.shows("3"))
    }
}
