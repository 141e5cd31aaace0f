package robotran.textediting

import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class InputWindowTest {
    private val long = (1..2_000).joinToString("\n") { "forward $it" }

    @Test
    fun `a short program is held as a whole`() {
        val draft = TextDocument("pen down\nbeep", TextSelection(3))
        val window = InputWindow.of(draft)
        assertEquals(draft.text, window.textOf(draft))
        assertEquals(TextDocument("beep", TextSelection(4)), window.applied(draft, "beep", TextSelection(4)))
    }

    @Test
    fun `of a long program only what is around the caret is held`() {
        val draft = TextDocument(long, TextSelection(long.length / 2))
        val window = InputWindow.of(draft)
        assertTrue(window.span.length < InputWindow.MAX_WHOLE_LENGTH)
        assertEquals(long, window.applied(draft, window.textOf(draft), window.selectionOf(draft)).text)
    }

    @Test
    fun `what replaces more than is held replaces all that is selected`() {
        val draft = TextDocument("a$long", TextSelection(1, long.length + 1))
        val window = InputWindow.of(draft)
        assertEquals(TextDocument("ab", TextSelection(2)), window.applied(draft, "b", TextSelection(1)))
        assertEquals("a", window.applied(draft, "", TextSelection(0)).text)
        assertEquals(draft, window.applied(draft, window.textOf(draft), window.selectionOf(draft)))
    }

    @Test
    fun `a part stays what it is while one writes in it`() {
        val draft = TextDocument(long, TextSelection(long.length / 2))
        val window = InputWindow.of(draft)
        val after = draft.replaced("x")
        val kept = assertNotNull(window.reusedFor(after, editBetween(draft.text, after.text)))
        assertEquals(window.span.start, kept.span.start)
        assertEquals(window.span.length + 1, kept.span.length)
        assertNull(window.reusedFor(draft.withCaret(0), null))
    }
}
