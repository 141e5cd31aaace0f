package robotran.ui.program

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import kotlinx.coroutines.runBlocking
import robotran.programs.Program
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.state.NoteKind
import robotran.workshop.state.Pane
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests the editor's help: completions, fixes, and runtime errors. */
@OptIn(ExperimentalTestApi::class)
class ProgramHelpTest {
    private fun ComposeUiTest.chooseComplete(byTouch: Boolean) {
        for (tag in listOf(ProgramTags.EDITOR_MORE, ProgramTags.tool(EditorCommand.Plain.COMPLETE))) {
            if (byTouch) {
                onNodeWithTag(tag).performTouchInput {
                    click()
                }
            } else {
                onNodeWithTag(tag).performMouseInput { click() }
            }
            pass(600)
        }
    }

    @Test
    fun `the menu offers what could come where the caret is, by mouse and by touch`() = onTablet { workshop ->
        for (byTouch in listOf(false, true)) {
            workshop.write("turn ")
            pass(300)
            chooseComplete(byTouch)
            onNodeWithTag(ProgramTags.COMPLETIONS).assertIsDisplayed()
            onNodeWithText("left").performTouchInput { click() }
            pass(300)
            assertEquals("turn left 90", workshop.text)
            assertEquals("90", workshop.selected)
        }
    }

    @Test
    fun `where nothing could come the menu says so`() = onTablet { workshop ->
        workshop.write("// a comment")
        pass(300)
        chooseComplete(byTouch = false)
        onNodeWithTag(ProgramTags.NO_COMPLETIONS).assertIsDisplayed()
        keys(listOf(Key.Escape))
        assertEquals(0, onAllNodesWithTag(ProgramTags.NO_COMPLETIONS).fetchSemanticsNodes().size)
    }

    @Test
    fun `a fix says what it does, does it, and leaves the keyboard to the text`() = onTablet { workshop ->
        for (byTouch in listOf(false, true)) {
            workshop.write("")
            focusProgram()
            workshop.write("forward5")
            pass(1_000)
            onNodeWithText("Put a space: forward 5").let { button ->
                if (byTouch) button.performTouchInput { click() } else button.performMouseInput { click() }
            }
            pass(300)
            assertEquals("forward 5", workshop.text)
            onRoot().performKeyInput { pressKey(Key.Backspace) }
            pass(300)
            assertEquals("forward ", workshop.text)
        }
    }

    @Test
    fun `the line that a run could not go on at is marked and brought into sight`() = onPhone { workshop ->
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        workshop.write("var x = 0\n" + "beep\n".repeat(60) + "show 10 / x", caret = 0)
        pass(300)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(60_000)
        workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
        pass(600)
        onNodeWithTag(ProgramTags.note(NoteKind.FAILURE)).assertIsDisplayed()
        workshop.write("beep")
        pass(300)
        assertEquals(0, onAllNodesWithTag(ProgramTags.note(NoteKind.FAILURE)).fetchSemanticsNodes().size)
    }

    @Test
    fun `an exception of Java is marked, too`() = onTablet { workshop ->
        val body = "int x = 0;\n        x = 1 / x;"
        val text = "public class A {\n    public static void main(String[] args) {\n        $body\n    }\n}\n"
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("A.java", text)))
        runBlocking { workshop.compilePrograms() }
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2_000)
        pass(600)
        onNodeWithTag(ProgramTags.note(NoteKind.FAILURE)).assertIsDisplayed()
    }
}
