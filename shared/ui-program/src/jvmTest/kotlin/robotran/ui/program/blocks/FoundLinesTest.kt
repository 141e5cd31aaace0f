package robotran.ui.program.blocks

import robotran.language.source.SourceSpan
import robotran.textediting.find.withSelected
import robotran.textediting.text.TextDocument
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests which lines the search marks. */
class FoundLinesTest {
    @Test
    fun `lines with matches are marked, and the one with the selected match more so`() {
        val draft = TextDocument("beep\nforward 2\nbeep\n")
        val matches = listOf(SourceSpan(0, 4), SourceSpan(15, 19))
        assertEquals(FoundLines(setOf(1, 3), now = 0), FoundLines.of(draft, matches))
        val selected = draft.withSelected(matches[1])
        assertEquals(FoundLines(setOf(1, 3), now = 3), FoundLines.of(selected, matches))
    }

    @Test
    fun `without matches no line is marked`() =
        assertEquals(FoundLines(), FoundLines.of(TextDocument("beep\n"), emptyList()))
}
