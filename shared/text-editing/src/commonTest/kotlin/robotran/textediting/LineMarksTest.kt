package robotran.textediting

import robotran.languagesupport.TextLines
import kotlin.test.Test
import kotlin.test.assertEquals

class LineMarksTest {
    private fun moved(before: String, after: String, vararg marks: Int): Set<Int> =
        marks.toSet().movedWith(checkNotNull(editBetween(before, after)), TextLines(before))

    @Test
    fun `marks below a new line move down and those above stay`() =
        assertEquals(setOf(1, 4), moved("a\nb\nc", "a\nb\nx\nc", 1, 3))

    @Test
    fun `a line that is pushed down takes its mark with it`() = assertEquals(setOf(2), moved("beep", "\nbeep", 1))

    @Test
    fun `a new line behind a marked line leaves the mark`() = assertEquals(setOf(1), moved("beep", "beep\n", 1))

    @Test
    fun `typing in a line moves nothing`() = assertEquals(setOf(1, 2), moved("a\nb", "ax\nb", 1, 2))

    @Test
    fun `the mark of a line that is taken out goes with it`() =
        assertEquals(setOf(1), moved("aa\nbb\ncc", "aa\ncc", 1, 2))

    @Test
    fun `a line that is taken out brings those below it up`() = assertEquals(setOf(2), moved("aa\nbb\ncc", "aa\ncc", 3))

    @Test
    fun `lines that are written anew keep their marks`() =
        assertEquals(setOf(2), moved("if x\nbeep\nend", "if x\n  beep\nend", 2))
}
