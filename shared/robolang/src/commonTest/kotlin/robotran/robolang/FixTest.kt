package robotran.robolang

import robotran.robolang.diagnostic.SourceFix
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class FixTest {
    @Test
    fun `a misspelt command is replaced`() = assertMended("foward 20", "forward 20")

    @Test
    fun `a forgotten space is put in`() {
        assertMended("forward20", "forward 20")
        assertMended("penup", "pen up")
    }

    @Test
    fun `a forgotten unit is put in`() {
        assertMended("wait 2 // a while", "wait 2 seconds // a while")
        assertMended("repeat 4\nend", "repeat 4 times\nend")
    }

    @Test
    fun `another spelling of a unit is replaced`() {
        assertMended("wait 5 secs", "wait 5 seconds")
        assertMended("forward 5 centimeters", "forward 5 cm")
        assertMended("turn left 90°", "turn left 90 degrees")
    }

    @Test
    fun `a second command moves to the next line with the same indentation`() =
        assertMended("  forward 20 turn left 90", "  forward 20\n  turn left 90")

    @Test
    fun `words left over are taken away with the space before them`() =
        assertMended("beep  please // now", "beep // now")

    @Test
    fun `numbers get their point`() {
        assertMended("forward 2,5", "forward 2.5")
        assertMended("forward .5", "forward 0.5")
        assertMended("show 5.", "show 5.0")
    }

    @Test
    fun `characters of other languages are replaced`() {
        assertMended("beep;", "beep")
        assertMended("beep # now", "beep // now")
        assertMended("forward –5", "forward -5")
    }

    @Test
    fun `a forgotten end is put behind the program`() = assertMended(
        "repeat 2 times\n  repeat 3 times\n    beep\n  end",
        "repeat 2 times\n  repeat 3 times\n    beep\n  end\nend",
    )

    @Test
    fun `a forgotten end is put before the line that closes the block around it`() = assertMended(
        "repeat 2 times\n  repeat 3 times\n    beep\nend",
        "repeat 2 times\n  repeat 3 times\n    beep\n  end\nend",
    )

    @Test
    fun `where there are several ways there is no fix`() {
        assertNull(mistakesOf("turn 90").single().fix)
        assertNull(mistakesOf("forward 3 metres").single().fix)
        assertNull(mistakesOf("hop").single().fix)
    }

    private fun assertMended(source: String, expected: String) {
        val fix = checkNotNull(mistakesOf(source).single().fix)
        val mended = apply(fix, source)
        assertEquals(expected, mended)
        assertEquals(emptyList(), mistakesOf(mended))
    }

    private fun apply(fix: SourceFix, source: String): String {
        val lines = source.lines().toMutableList()
        val place = fix.range.line - 1
        lines[place] = lines[place].replaceRange(fix.range.column - 1, fix.range.endColumn - 1, fix.replacement)
        return lines.joinToString("\n")
    }
}
