package robotran.textediting

import robotran.textediting.find.Search
import robotran.textediting.find.nextMatch
import robotran.textediting.find.previousMatch
import robotran.textediting.find.withAllReplaced
import robotran.textediting.find.withSelected
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals

class SearchTest {
    private val text = "Side = 2\nforward side\nsideways"

    @Test
    fun `capitals count only if they are to`() {
        assertEquals(listOf(0, 17, 22), Search("side").matchesIn(text).map { it.start })
        assertEquals(listOf(0), Search("Side", matchCase = true).matchesIn(text).map { it.start })
    }

    @Test
    fun `whole words are no parts of longer ones`() =
        assertEquals(listOf(0, 17), Search("side", wholeWords = true).matchesIn(text).map { it.start })

    @Test
    fun `nothing is found of nothing`() = assertEquals(emptyList(), Search("").matchesIn(text))

    @Test
    fun `one goes from match to match, round and round`() {
        val matches = Search("side").matchesIn(text)
        var draft = TextDocument(text, TextSelection(5))
        val gone = (1..4).map {
            val next = draft.nextMatch(matches)
            draft = draft.withSelected(matches[next])
            next
        }
        assertEquals(listOf(1, 2, 0, 1), gone)
        assertEquals(0, draft.previousMatch(matches))
    }

    @Test
    fun `all are replaced at once and the caret stays at its word`() {
        val matches = Search("side", wholeWords = true).matchesIn(text)
        val draft = TextDocument(text, TextSelection(text.length)).withAllReplaced(matches, "edge length")
        assertEquals("edge length = 2\nforward edge length\nsideways", draft.text)
        assertEquals(draft.text.length, draft.selection.caret)
    }
}
