package robotran.robolang

import robotran.language.source.SourceFix
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
    fun `pasted blanks become spaces, all of a line at once, and what cannot be seen is deleted`() {
        assertMended("repeat\u20092\u3000times // 2\u2009times\nend", "repeat 2 times // 2\u2009times\nend")
        assertMended("turn\u3000left\u202F90", "turn left 90")
        assertMended("\u200Bbeep", "beep")
        assertMended("\uFF46\uFF4F\uFF52\uFF57\uFF41\uFF52\uFF44\u2003\uFF12\uFF10 // 20", "forward 20 // 20")
    }

    @Test
    fun `a name of several words becomes one`() {
        assertMended("var my speed = 5\nshow my_speed", "var my_speed = 5\nshow my_speed")
        val declared = "var way = 5\nvar my_speed = 5\nshow way\n"
        assertMended("${declared}forward my speed", "${declared}forward my_speed")
        assertMended("for the side from 1 to 4\nend", "for the_side from 1 to 4\nend")
        assertMended("procedure big square()\nend", "procedure big_square()\nend")
    }

    @Test
    fun `a word that means nothing before a value is taken away`() {
        assertMended("turn right by 90", "turn right 90")
        assertMended("show random 1 6", "show random(1, 6)")
        assertMended("show random 1, -6", "show random(1, -6)")
        assertMended("if touch left\nend", "if left bumper\nend")
    }

    @Test
    fun `of several names that are as near none is chosen`() {
        assertMended("var way1 = 2\nshow wy1", "var way1 = 2\nshow way1")
        assertNull(errorsOf("var way1 = 1\nvar way2 = 2\nshow way3\nshow way1 + way2").single().fix)
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
        assertNull(errorsOf("turn 90").single().fix)
        assertNull(errorsOf("forward 3 metres").single().fix)
        assertNull(errorsOf("hop").single().fix)
    }

    private fun assertMended(source: String, expected: String) {
        val fix = checkNotNull(errorsOf(source).single().fix)
        val mended = apply(fix, source)
        assertEquals(expected, mended)
        assertEquals(emptyList(), errorsOf(mended))
    }

    private fun apply(fix: SourceFix, source: String): String {
        val lines = source.lines().toMutableList()
        val place = fix.range.line - 1
        lines[place] = lines[place].replaceRange(fix.range.column - 1, fix.range.endColumn - 1, fix.replacement)
        return lines.joinToString("\n")
    }
}
