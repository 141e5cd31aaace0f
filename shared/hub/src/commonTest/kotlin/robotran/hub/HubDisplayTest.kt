package robotran.hub

import robotran.brick.lights.LightFont
import robotran.hub.display.HubDisplay
import robotran.hub.display.HubScreen
import robotran.hub.display.MatrixFont
import robotran.hub.model.HubModel
import robotran.hub.program.HubError
import robotran.hub.program.HubNative
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class HubDisplayTest {
    private val bench = HubBench()
    private val screen: HubScreen get() = bench.brick.state.screen

    @Test
    fun `a number is two digits, with a dot for a minus, and an arrow beyond 99`() {
        bench.call(HubNative.DISPLAY_NUMBER, 42)
        assertEquals("#..##\n#...#\n##.##\n.#.#.\n.#.##\n", screen.toArt())
        bench.call(HubNative.DISPLAY_NUMBER, -7)
        assertEquals("+", screen.toArt().lines()[2][2].toString())
        assertEquals("-7", screen.shown)
        bench.call(HubNative.DISPLAY_NUMBER, 100)
        assertEquals(".#...\n..#..\n...#.\n..#..\n.#...\n", screen.toArt())
        bench.call(HubNative.DISPLAY_NUMBER, -100)
        assertEquals("...#.\n..#..\n.#...\n..#..\n...#.\n", screen.toArt())
        assertTrue(screen.shows("-100"))
    }

    @Test
    fun `each character from the blank to the tilde looks different`() {
        val looks = LightFont.PRINTABLE.map { MatrixFont.lightsOf(it.toChar()) }
        assertEquals(95, looks.distinct().size)
        assertTrue(looks.all { it.size == 25 })
    }

    @Test
    fun `the letters of a text are shown one after another, each for as long as with Pybricks`() {
        val events = recorded("25-display-events").map { it.substringBefore(' ').toInt() }
        val (on, off, second, end) = events.dropWhile { it != 266 }
        assertEquals(listOf(500, 550, 1050), listOf(off - on, second - on, end - on).map { (it + 1) / 10 * 10 })
        bench.call(HubNative.DISPLAY_TEXT, "OK")
        assertEquals(1100, bench.hub.textMillisecondsLeft)
        val letter = screen.lights
        bench.wait(499)
        assertEquals(letter, screen.lights)
        bench.wait(1)
        assertEquals(MatrixFont.DARK, screen.lights)
        bench.wait(50)
        assertNotEquals(MatrixFont.DARK, screen.lights)
        assertEquals("OK", screen.shown)
        bench.wait(550)
        assertEquals(MatrixFont.DARK to "", screen.lights to screen.shown)
        assertEquals(0, bench.hub.textMillisecondsLeft)
    }

    @Test
    fun `a character that the lights do not have is an invalid argument`() {
        assertEquals(null, bench.call(HubNative.DISPLAY_CHAR, "A"))
        for (bad in listOf("AB", "", "ä")) {
            assertEquals(HubError.INVALID_ARGUMENT, bench.call(HubNative.DISPLAY_CHAR, bad), bad)
        }
        assertEquals(HubError.INVALID_ARGUMENT, bench.call(HubNative.DISPLAY_TEXT, "aä"))
        assertTrue(recorded("25-display").any { it.startsWith("AB ValueError") })
    }

    @Test
    fun `what is printed is kept, the newest lines, and counts as shown`() {
        repeat(HubScreen.MOST_PRINTED + 5) { bench.call(HubNative.PRINT, "line $it") }
        assertEquals(HubScreen.MOST_PRINTED, screen.printed.size)
        assertTrue(screen.shows("line 204"))
        assertTrue(!screen.shows("line 4"))
        bench.call(HubNative.PRINT, "1234")
        assertTrue(screen.shows("1234.0"))
    }

    @Test
    fun `a screen has rows, of which the upper ones move out`() {
        val display = HubDisplay(HubModel.NXT_PYBRICKS)
        repeat(10) { display.printRow("row $it of the screen") }
        assertEquals("row 2 of the scr", display.screen.lines.first())
        assertEquals("row 9 of the scr", display.screen.lines.last())
        display.clearRows()
        assertEquals("", display.screen.text)
    }

    @Test
    fun `a hub without a part refuses what needs it`() {
        val technic = HubBench(HubModel.TECHNIC_HUB)
        assertEquals(HubError.NO_SUCH_PART, technic.call(HubNative.DISPLAY_NUMBER, 1))
        assertEquals(HubError.NO_SUCH_PART, technic.call(HubNative.SPEAKER_BEEP, 500, 100))
        assertEquals(HubError.NO_SUCH_PART, technic.call(HubNative.SCREEN_PRINT, "1"))
        assertEquals(HubError.NO_SUCH_PART, HubBench(HubModel.NXT_PYBRICKS).call(HubNative.LIGHT_ON, 4))
    }
}
