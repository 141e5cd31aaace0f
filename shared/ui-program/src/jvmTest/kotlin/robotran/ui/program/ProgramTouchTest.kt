package robotran.ui.program

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.click
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.swipeUp
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.state.Pane
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests editing by touch and mouse. */
@OptIn(ExperimentalTestApi::class)
class ProgramTouchTest {
    @Test
    fun `a touch on a line's number sets a breakpoint, which moves with its line`() = onTablet { workshop ->
        workshop.write("beep\nbuzz\nbeep", caret = 0)
        pass(100)
        onNodeWithTag(ProgramTags.PROGRAM).performTouchInput { click(Offset(20f, 30f)) }
        pass(300)
        assertEquals(setOf(2), workshop.state.programs.breakpoints)
        workshop.write("\nbeep\nbuzz\nbeep", caret = 1)
        assertEquals(setOf(3), workshop.state.programs.breakpoints)
        focusProgram()
        keys(listOf(Key.F9))
        assertEquals(setOf(2, 3), workshop.state.programs.breakpoints)
    }

    @Test
    fun `a finger puts the caret, selects a word by resting on it, and then cuts it`() = onPhone { workshop ->
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).performClick()
        workshop.write("forward 20\nbeep\n", caret = 0)
        pass(300)
        onNodeWithTag(ProgramTags.PROGRAM).performTouchInput { click(Offset(300f, 10f)) }
        pass(400)
        assertEquals(10, workshop.caret)
        rest(ProgramTags.PROGRAM, Offset(80f, 10f))
        assertEquals("forward", workshop.selected)
        onNodeWithTag(ProgramTags.selection(EditorCommand.Plain.CUT)).performClick()
        pass(200)
        assertEquals(" 20\nbeep\n", workshop.text)
        assertEquals(0, onAllNodesWithTag(ProgramTags.SELECTION_BAR).fetchSemanticsNodes().size)
    }

    @Test
    fun `a mouse selects by dragging and by a double click`() = onTablet { workshop ->
        workshop.write("forward 20\nbeep\n", caret = 0)
        pass(100)
        onNodeWithTag(ProgramTags.PROGRAM).performMouseInput {
            moveTo(Offset(50f, 10f))
            press()
            moveTo(Offset(60f, 10f))
            moveTo(Offset(300f, 10f))
            release()
        }
        pass(800)
        assertEquals("forward 20", workshop.selected)
        onNodeWithTag(ProgramTags.PROGRAM).performMouseInput { doubleClick(Offset(60f, 31f)) }
        pass(200)
        assertEquals("beep", workshop.selected)
    }

    @Test
    fun `a long program scrolls with a finger and is still written in where the caret is`() = onTablet { workshop ->
        val text = (1..2_000).joinToString("\n") { "forward $it" }
        workshop.write(text, caret = text.length)
        pass(300)
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("5")
        pass(300)
        assertEquals(text + "5", workshop.text)
        onNodeWithTag(ProgramTags.PROGRAM).performTouchInput { swipeUp() }
        pass(500)
        assertEquals(text + "5", workshop.text)
        onNodeWithTag(ProgramTags.PROGRAM).assertTextContains("forward 20005", substring = true)
    }
}
