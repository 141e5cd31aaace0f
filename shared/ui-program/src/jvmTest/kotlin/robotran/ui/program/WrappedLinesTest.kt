package robotran.ui.program

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTouchInput
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.pass
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.Workshop
import robotran.workshop.state.Pane
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals

/** Tests the text editor where a line is longer than the screen is wide: it goes on in the row below. */
@OptIn(ExperimentalTestApi::class)
class WrappedLinesTest {
    @Test
    fun `a touch in the second row of a line puts the caret there`() = onLongLine { workshop ->
        touch(x = 400f, row = 1)
        assertEquals(LINE.length, workshop.caret)
        touch(x = 400f, row = 0)
        assertEquals(FIRST_ROW.trimEnd().length, workshop.caret)
        touch(x = 400f, row = 2)
        assertEquals(LINE.length + " beep".length, workshop.caret)
    }

    @Test
    fun `keys go up and down by rows, and home and end by lines`() = onLongLine { workshop ->
        touch(x = 60f, row = 0)
        focusProgram()
        keys(listOf(Key.DirectionDown))
        assertEquals(FIRST_ROW.length, workshop.caret)
        keys(listOf(Key.DirectionDown))
        assertEquals(1, workshop.caret - LINE.length - 1)
        keys(listOf(Key.DirectionUp, Key.MoveEnd))
        assertEquals(LINE.length, workshop.caret)
    }

    @Test
    fun `a breakpoint is set beside any row of its line`() = onLongLine { workshop ->
        onNodeWithTag(ProgramTags.PROGRAM).performTouchInput { click(Offset(20f, rowCentre(2))) }
        pass(300)
        assertEquals(setOf(2), workshop.state.programs.breakpoints)
        onNodeWithTag(ProgramTags.PROGRAM).performTouchInput { click(Offset(20f, rowCentre(1))) }
        pass(300)
        assertEquals(setOf(1, 2), workshop.state.programs.breakpoints)
    }

    @Test
    fun `what is typed goes in at the caret, and breaks no line of the program`() = onLongLine { workshop ->
        touch(x = 400f, row = 1)
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput(" or right bumper")
        pass(300)
        assertEquals("$LINE or right bumper\nbeep", workshop.text)
    }

    private fun onLongLine(check: ComposeUiTest.(Workshop) -> Unit) = onPhone { workshop ->
        onNodeWithTag(ScreenTags.tab(Pane.PROGRAM)).performClick()
        workshop.write("$LINE\nbeep", caret = 0)
        pass(300)
        check(workshop)
    }

    private fun ComposeUiTest.touch(x: Float, row: Int) {
        onNodeWithTag(ProgramTags.PROGRAM).performTouchInput { click(Offset(x, rowCentre(row))) }
        pass(600)
    }

    private companion object {
        const val LINE = "wait until left bumper or right bumper or left bumper"
        const val FIRST_ROW = "wait until left bumper or right bumper "

        /** The rows are 21 high. */
        fun rowCentre(row: Int) = 6f + 21f * row + 10f
    }
}
