package robotran.textediting

import robotran.languagesupport.TextLines
import robotran.textediting.rows.TextRows
import robotran.textediting.rows.rowsOf
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals

class TextRowsTest {
    private fun rows(line: String, columns: Int): List<String> =
        rowsOf(line, columns).run { (0..<count).map { shown.text.substring(start(it), end(it)) } }

    @Test
    fun `a line is broken behind a blank, which stays at the end of its row`() {
        assertEquals(
            listOf("wait until left ", "bumper or ", "right ", "bumper"),
            rows("wait until left bumper or right bumper", 15),
        )
        assertEquals(listOf("wait until  ", "left"), rows("wait until  left", 10))
    }

    @Test
    fun `a line that just fits, or is followed by blanks only, has one row`() {
        assertEquals(listOf("forward 20"), rows("forward 20", 10))
        assertEquals(listOf("forward 20   "), rows("forward 20   ", 10))
    }

    @Test
    fun `a remark behind code begins a row if it does not fit`() {
        assertEquals(listOf("forward 20  ", "// go on and ", "on"), rows("forward 20  // go on and on", 16))
        assertEquals(listOf("// forward ", "20"), rows("// forward 20", 11))
    }

    @Test
    fun `rows below the first are indented more than the line`() {
        assertEquals(8, rowsOf("    side <= 2; side++", 20).indent)
        assertEquals(4, rowsOf("      side <= 2", 9).indent)
    }

    @Test
    fun `without a blank a line is broken beside an operator, and otherwise within a word`() {
        assertEquals(listOf("Motor.A", ".forward", "();"), rows("Motor.A.forward();", 12))
        assertEquals(listOf("turn(a,", "b,c)"), rows("turn(a,b,c)", 8))
        assertEquals(listOf("a<=", "b"), rows("a<=b", 3))
        assertEquals(listOf("abcdefghij", "klmnop"), rows("abcdefghijklmnop", 10))
    }

    @Test
    fun `a row does not end before half of an emoji, and letters that are wide take two cells`() {
        assertEquals(listOf("ab\uD83D\uDE00", "\uD83D\uDE00"), rows("ab\uD83D\uDE00\uD83D\uDE00", 4))
        assertEquals(listOf("山山", "山"), rows("山山山", 4))
    }

    @Test
    fun `no row is without a character, however narrow it is`() =
        assertEquals(listOf("\uD83D\uDE00", "\uD83D\uDE00"), rows("\uD83D\uDE00\uD83D\uDE00", 1))

    @Test
    fun `rows of a text are counted through all lines`() {
        val rows = TextRows(TextLines("beep\nforward 20 centimetres\nbeep"), columns = 16)
        assertEquals(4, rows.count)
        assertEquals(listOf(0, 1, 3, 4), (0..3).map(rows::before))
        assertEquals(listOf(0, 1, 1, 2), (0..3).map(rows::lineOf))
    }

    @Test
    fun `up and down go by rows, and keep their place over shorter ones`() {
        val draft = TextDocument("forward 20 centimetres\nbeep", TextSelection(5))
        val rows = TextRows(draft.lines, columns = 16)
        val below = draft.moved(CaretMove.DOWN, selecting = false, rows = rows)
        assertEquals(12, below.selection.caret)
        val last = below.moved(CaretMove.DOWN, selecting = false, goal = 5, rows = rows)
        assertEquals(draft.text.length, last.selection.caret)
        assertEquals(5, below.moved(CaretMove.UP, selecting = false, goal = 5, rows = rows).selection.caret)
        assertEquals(5, draft.moved(CaretMove.DOWN, selecting = true, rows = rows).selection.anchor)
    }

    @Test
    fun `going up from a longer row does not slip into the row below`() {
        val draft = TextDocument("forward 20 centimetres", TextSelection(22))
        val rows = TextRows(draft.lines, columns = 16)
        assertEquals(10, draft.moved(CaretMove.UP, selecting = false, rows = rows).selection.caret)
    }

    @Test
    fun `a place is found again by its row and cell, also behind tabs`() {
        val line = rowsOf("\twait until left bumper or right bumper", 16)
        for (column in 0..line.shown.length) {
            assertEquals(column, line.columnAt(line.rowOf(column), line.cellOf(column)), "column $column")
        }
    }
}
