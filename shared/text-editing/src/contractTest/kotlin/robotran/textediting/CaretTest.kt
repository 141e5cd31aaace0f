package robotran.textediting

import robotran.languagesupport.TextLines
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.textediting.text.withWordSelected
import kotlin.test.Test
import kotlin.test.assertEquals

class CaretTest {
    private val draft = TextDocument("repeat 4 times\n  forward 20\nend", TextSelection(0))

    private fun TextDocument.after(vararg moves: CaretMove, selecting: Boolean = false) =
        moves.fold(this) { now, move -> now.moved(move, selecting) }.selection

    @Test
    fun `arrows go a character, and over the line's end`() {
        assertEquals(TextSelection(1), draft.after(CaretMove.RIGHT))
        assertEquals(TextSelection(14), draft.after(CaretMove.DOWN, CaretMove.LEFT))
        assertEquals(TextSelection(0), draft.after(CaretMove.LEFT, CaretMove.UP))
    }

    @Test
    fun `going down past the last line leads to the text's end`() =
        assertEquals(TextSelection(draft.text.length), draft.after(CaretMove.DOWN, CaretMove.DOWN, CaretMove.DOWN))

    @Test
    fun `a column is kept where the line is long enough`() {
        val below = draft.withCaret(10).moved(CaretMove.PAGE_DOWN, selecting = false, goal = 10, page = 2)
        assertEquals(draft.text.length, below.selection.caret)
        assertEquals(TextSelection(25), draft.withCaret(10).after(CaretMove.DOWN))
    }

    @Test
    fun `words are gone over as a whole`() {
        assertEquals(TextSelection(6), draft.after(CaretMove.WORD_RIGHT))
        assertEquals(TextSelection(7), draft.withCaret(8).after(CaretMove.WORD_LEFT))
    }

    @Test
    fun `a line begins with its first word, and then with its first column`() {
        assertEquals(TextSelection(17), draft.withCaret(20).after(CaretMove.LINE_START))
        assertEquals(TextSelection(15), draft.withCaret(20).after(CaretMove.LINE_START, CaretMove.LINE_START))
        assertEquals(TextSelection(27), draft.withCaret(20).after(CaretMove.LINE_END))
    }

    @Test
    fun `what lies between is selected, and an arrow leaves the selection at its side`() {
        val selected = draft.copy(selection = draft.after(CaretMove.RIGHT, CaretMove.WORD_RIGHT, selecting = true))
        assertEquals("repeat", selected.selectedText)
        assertEquals(TextSelection(6), selected.after(CaretMove.RIGHT))
        assertEquals(TextSelection(0), selected.after(CaretMove.LEFT))
    }

    @Test
    fun `a long press selects a word`() {
        assertEquals("forward", draft.withWordSelected(20).selectedText)
        assertEquals("  ", TextDocument("(  )").withWordSelected(2).selectedText)
        assertEquals("(", TextDocument("x=(+").withWordSelected(2).selectedText)
        assertEquals("", TextDocument("+\n").withWordSelected(1).selectedText)
    }

    @Test
    fun `lines know their places`() {
        val lines = TextLines("a\n\nbcd")
        assertEquals(3, lines.count)
        assertEquals(listOf("a", "", "bcd"), (0..2).map(lines::line))
        assertEquals(listOf(0, 0, 1, 2, 2, 2, 2), (0..6).map(lines::lineOf))
        assertEquals(5, lines.offset(2, 2))
        assertEquals(2, lines.offset(1, 9))
    }
}
