package robotran.ui.program.editor

import androidx.compose.ui.platform.ClipboardManager
import androidx.compose.ui.text.AnnotatedString
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.textediting.CaretMove
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class EditorControlTest {
    private val written = mutableListOf<TextDocument>()
    private val control = EditorControl(ProgramLanguage.ROBOLANG, EditorView(), brick = BrickKind.RCX) { draft, _ ->
        written +=
            draft
    }.apply {
        clipboard = object : ClipboardManager {
            private var text: AnnotatedString? = null

            override fun getText() = text

            override fun setText(annotatedString: AnnotatedString) {
                text = annotatedString
            }
        }
    }

    @Test
    fun `what was cut is put in again, with the line ends and the indents of the editor`() {
        control.follow(TextDocument("pen down\nbeep", TextSelection(9, 13)))
        control.perform(EditorCommand.Plain.CUT)
        assertEquals("pen down\n", control.draft.text)
        control.perform(EditorCommand.Plain.PASTE)
        control.perform(EditorCommand.Plain.PASTE)
        assertEquals("pen down\nbeepbeep", control.draft.text)
        control.clipboard.setText(AnnotatedString("a\r\n\tb"))
        control.perform(EditorCommand.Plain.PASTE)
        assertEquals("pen down\nbeepbeepa\n  b", written.last().text)
    }

    @Test
    fun `what there is no room for is told but not written, and the field is as it was`() {
        val small =
            EditorControl(ProgramLanguage.ROBOLANG, EditorView(), BrickKind.RCX, { it.text.length <= 8 }) { draft, _ ->
                written +=
                    draft
            }
        small.follow(TextDocument("beep").withCaret(4))
        assertEquals("beep", small.link.fieldFor(small.draft).text)
        small.received(TextDocument("beep and more", TextSelection(13)), isComposing = false)
        assertEquals("beep and more", written.last().text)
        assertEquals("beep", small.draft.text)
        assertEquals("beep", small.link.fieldFor(small.draft).text)
        small.received(TextDocument("beep 1", TextSelection(6)), isComposing = false)
        assertEquals("beep 1", small.draft.text)
    }

    @Test
    fun `several keys between two pictures are all written`() {
        control.follow(TextDocument(""))
        for (letter in "beep") control.type(letter.toString())
        assertEquals("beep", written.last().text)
    }

    @Test
    fun `going up and down keeps the column over shorter lines`() {
        control.follow(TextDocument("forward 20\nbeep\nforward 30", TextSelection(10)))
        val down = EditorCommand.Move(CaretMove.DOWN, selecting = false)
        control.perform(down)
        assertEquals(15, control.draft.selection.caret)
        control.perform(down)
        assertEquals(26, control.draft.selection.caret)
    }

    @Test
    fun `keys go through what is offered before they go through the text`() {
        control.follow(TextDocument("turn ", TextSelection(5)))
        control.perform(EditorCommand.Plain.COMPLETE)
        assertEquals(listOf("left", "right"), assertNotNull(control.completions).items.map { it.label })
        assertTrue(control.performOnOffered(EditorCommand.Move(CaretMove.UP, selecting = false), isEnter = false))
        assertEquals(1, control.chosen)
        assertFalse(control.performOnOffered(EditorCommand.Move(CaretMove.LEFT, selecting = false), isEnter = false))
        assertTrue(control.performOnOffered(null, isEnter = true))
        assertEquals("turn right 90", control.draft.text)
        assertEquals("90", control.draft.selectedText)
        assertNull(control.completions)
        assertFalse(control.performOnOffered(null, isEnter = true))
    }

    @Test
    fun `Tab fills up to the next step`() {
        control.follow(TextDocument("a", TextSelection(1)))
        control.perform(EditorCommand.Plain.INDENT)
        assertEquals("a ", control.draft.text)
        control.perform(EditorCommand.Plain.INDENT)
        assertEquals("a   ", control.draft.text)
    }
}
