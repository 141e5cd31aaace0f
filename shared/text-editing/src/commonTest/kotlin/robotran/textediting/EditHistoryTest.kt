package robotran.textediting

import robotran.language.ProgramLanguage
import robotran.programs.support
import robotran.textediting.text.TextDocument
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull

class EditHistoryTest {
    private fun write(text: String): Pair<TextDocument, EditHistory> {
        var draft = TextDocument("")
        var history = EditHistory()
        for (character in text) {
            val after = draft.replaced(character.toString())
            history = history.recorded(draft, after, EditKind.TYPING)
            draft = after
        }
        return draft to history
    }

    @Test
    fun `what is typed goes back word by word and comes again`() {
        val (draft, history) = write("pen down\nbeep")
        val once = checkNotNull(history.undone(draft))
        assertEquals("pen down\n", once.first.text)
        val twice = checkNotNull(once.second.undone(once.first))
        assertEquals("pen down", twice.first.text)
        val again = checkNotNull(twice.second.redone(twice.first))
        assertEquals("pen down\n", again.first.text)
    }

    @Test
    fun `what was erased comes back in one go with the caret where it was`() {
        val (draft, history) = write("beep")
        val shorter = draft.erasedBackwards(ProgramLanguage.ROBOLANG.support.code)
        val shortest = shorter.erasedBackwards(ProgramLanguage.ROBOLANG.support.code)
        val erased = history.recorded(draft, shorter, EditKind.ERASING).recorded(shorter, shortest, EditKind.ERASING)
        assertEquals(draft, erased.undone(shortest)?.first)
    }

    @Test
    fun `a change after undoing is the end of what was undone`() {
        val (draft, history) = write("beep")
        val (back, undone) = checkNotNull(history.undone(draft))
        val other = undone.recorded(back, back.replaced("buzz"), EditKind.OTHER)
        assertFalse(other.canRedo)
        assertNull(other.redone(back))
    }

    @Test
    fun `only so much is remembered`() {
        var history = EditHistory()
        var draft = TextDocument("")
        repeat(EditHistory.MAX_STEPS + 50) {
            val after = draft.replaced("x")
            history = history.recorded(draft, after, EditKind.OTHER)
            draft = after
        }
        var steps = 0
        while (true) {
            val (before, rest) = history.undone(draft) ?: break
            draft = before
            history = rest
            steps++
        }
        assertEquals(EditHistory.MAX_STEPS, steps)
    }
}
