package robotran.textediting

import robotran.language.ProgramLanguage
import robotran.programs.support
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals

class InputLinkTest {
    private val link = InputLink(ProgramLanguage.ROBOLANG.support.code)

    private fun TextDocument.fieldTyped(typed: String) = replaced(typed)

    @Test
    fun `what is typed into the field comes into the text, with the indent of the language`() {
        val draft = TextDocument("repeat forever", TextSelection(14))
        val field = link.fieldFor(draft)
        assertEquals("repeat forever\n  ", link.received(draft, field.fieldTyped("\n"), isComposing = false).text)
    }

    @Test
    fun `what is typed before the screen is drawn again is not lost`() {
        val draft = TextDocument("repeat forever", TextSelection(14))
        val first = link.fieldFor(draft).fieldTyped("\n")
        val after = link.received(draft, first, isComposing = false)
        val second = first.fieldTyped("b")
        assertEquals("repeat forever\n  b", link.received(after, second, isComposing = false).text)
    }

    @Test
    fun `an input method's word is taken as it is`() {
        val draft = TextDocument("", TextSelection(0))
        link.fieldFor(draft)
        assertEquals("be", link.received(draft, TextDocument("be", TextSelection(2)), isComposing = true).text)
    }

    @Test
    fun `a word that an input method changes again before the screen is drawn is not lost`() {
        var draft = TextDocument("// \nbeep", TextSelection(3))
        link.fieldFor(draft)
        for (stage in listOf("~", "ñ", "にほ", "日本")) {
            draft =
                link.received(
                    draft,
                    TextDocument("// $stage\nbeep", TextSelection(3 + stage.length)),
                    isComposing = true,
                )
        }
        assertEquals("// 日本\nbeep", draft.text)
        draft = link.received(draft, TextDocument("// 日本", TextSelection(5)), isComposing = false)
        assertEquals("// 日本", draft.text)
        assertEquals(TextDocument("// 日本", TextSelection(5)), link.fieldFor(draft))
    }

    @Test
    fun `erasing, selecting and replacing in the field do the same in the text`() {
        val draft = TextDocument("forward 20", TextSelection(10))
        link.fieldFor(draft)
        val selected = link.received(draft, TextDocument("forward 20", TextSelection(0, 7)), isComposing = false)
        assertEquals("forward", selected.selectedText)
        link.fieldFor(selected)
        assertEquals(
            "backward 20",
            link.received(selected, TextDocument("backward 20", TextSelection(8)), isComposing = false).text,
        )
    }

    @Test
    fun `everything that is selected goes, however much it is`() {
        val text = "forward 20\n".repeat(2_000)
        val draft = TextDocument(text, TextSelection(0, text.length))
        link.fieldFor(draft)
        assertEquals("", link.received(draft, TextDocument("", TextSelection(0)), isComposing = false).text)
        assertEquals(
            "b",
            link.received(draft, TextDocument("b", TextSelection(1)), isComposing = false).text.takeLast(1),
        )
    }
}
