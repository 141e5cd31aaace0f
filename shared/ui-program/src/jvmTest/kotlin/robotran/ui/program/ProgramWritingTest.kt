package robotran.ui.program

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import robotran.programs.Program
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.event.ProgramEvent
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals

/** Tests editing by keyboard: typing, undo, caret movement, selection, completions. */
@OptIn(ExperimentalTestApi::class)
class ProgramWritingTest {
    @Test
    fun `typing writes, and a new line inside a block stands further right`() = onTablet { workshop ->
        workshop.write("repeat forever")
        pass(100)
        focusProgram()
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("\n")
        pass(100)
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("beep")
        pass(100)
        assertEquals("repeat forever\n  beep", workshop.text)
    }

    @Test
    fun `what was typed is taken back and done again, by button and by key`() = onTablet { workshop ->
        workshop.write("beep")
        pass(100)
        onNodeWithTag(ProgramTags.REDO).assertIsNotEnabled()
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput(" ")
        pass(100)
        onNodeWithTag(ProgramTags.UNDO).assertIsEnabled().performClick()
        pass(100)
        assertEquals("beep", workshop.text)
        onNodeWithTag(ProgramTags.REDO).performClick()
        pass(100)
        assertEquals("beep ", workshop.text)
        focusProgram()
        keys(listOf(Key.Z), with = Key.CtrlLeft)
        assertEquals("beep", workshop.text)
        keys(listOf(Key.Y), with = Key.CtrlLeft)
        assertEquals("beep ", workshop.text)
    }

    @Test
    fun `keys move the caret, select, erase, comment out and double lines`() = onTablet { workshop ->
        workshop.write("forward 20\nbeep", caret = 0)
        pass(100)
        focusProgram()
        keys(listOf(Key.MoveEnd))
        assertEquals(10, workshop.caret)
        keys(listOf(Key.DirectionLeft), with = Key.CtrlLeft)
        assertEquals(8, workshop.caret)
        keys(listOf(Key.MoveEnd), with = Key.ShiftLeft)
        assertEquals("20", workshop.selected)
        keys(listOf(Key.Backspace))
        assertEquals("forward \nbeep", workshop.text)
        keys(listOf(Key.DirectionDown))
        keys(listOf(Key.Slash), with = Key.CtrlLeft)
        assertEquals("forward \n// beep", workshop.text)
        keys(listOf(Key.D), with = Key.CtrlLeft)
        assertEquals("forward \n// beep\n// beep", workshop.text)
        keys(listOf(Key.DirectionUp, Key.DirectionUp), with = Key.AltLeft)
        assertEquals("// beep\nforward \n// beep", workshop.text)
        keys(listOf(Key.A), with = Key.CtrlLeft)
        assertEquals(workshop.text, workshop.selected)
    }

    @Test
    fun `Tab indents for who writes, and Escape lets it leave the text`() = onTablet { workshop ->
        workshop.write("beep", caret = 0)
        pass(100)
        focusProgram()
        keys(listOf(Key.DirectionRight, Key.DirectionLeft))
        keys(listOf(Key.Tab))
        assertEquals("  beep", workshop.text)
        keys(listOf(Key.Tab), with = Key.ShiftLeft)
        assertEquals("beep", workshop.text)
        keys(listOf(Key.Escape))
        keys(listOf(Key.Tab))
        assertEquals("beep", workshop.text)
        assertNotEquals(
            true,
            onNodeWithTag(ProgramTags.PROGRAM).fetchSemanticsNode().config.getOrNull(SemanticsProperties.Focused),
        )
    }

    @Test
    fun `what is cut is gone, however much it is`() = onTablet { workshop ->
        for (text in listOf("beep\n", "beep\n".repeat(2_000))) {
            workshop.write(text, caret = text.length, anchor = 0)
            pass(100)
            focusProgram()
            keys(listOf(Key.X), with = Key.CtrlLeft)
            assertEquals("", workshop.text)
        }
    }

    @Test
    fun `what could come is offered with a line of help, chosen by key or by touch`() = onTablet { workshop ->
        workshop.write("")
        pass(100)
        focusProgram()
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("f")
        pass(50)
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("o")
        pass(200)
        onNodeWithTag(ProgramTags.COMPLETIONS).assertIsDisplayed()
        keys(listOf(Key.Enter))
        assertEquals("forward 20", workshop.text)
        assertEquals("20", workshop.selected)
        workshop.write("tu")
        pass(100)
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("r")
        pass(200)
        onAllNodesWithText("turn").onFirst().performClick()
        pass(100)
        assertEquals("turn ", workshop.text)
        onAllNodesWithText("right").onFirst().performClick()
        pass(100)
        assertEquals("turn right 90", workshop.text)
        assertEquals(0, onAllNodesWithTag(ProgramTags.COMPLETIONS).fetchSemanticsNodes().size)
    }

    @Test
    fun `the methods of a motor are offered behind its point`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Mine.java", "Motor.A")))
        workshop.write("Motor.A")
        pass(100)
        focusProgram()
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput(".")
        pass(200)
        onNodeWithText("forward()").assertIsDisplayed()
        onNodeWithText("Turns the motor forward until it is told otherwise.").assertIsDisplayed()
        keys(listOf(Key.Escape))
        assertEquals(0, onAllNodesWithTag(ProgramTags.COMPLETIONS).fetchSemanticsNodes().size)
    }

    @Test
    fun `the size of the text is kept in the settings`() = onTablet { workshop ->
        focusProgram()
        keys(listOf(Key.Equals, Key.Equals), with = Key.CtrlLeft)
        assertEquals(17f, workshop.state.settings.codeSize)
        keys(listOf(Key.Minus), with = Key.CtrlLeft)
        assertEquals(16f, workshop.state.settings.codeSize)
        keys(listOf(Key.Zero), with = Key.CtrlLeft)
        assertEquals(15f, workshop.state.settings.codeSize)
    }
}
