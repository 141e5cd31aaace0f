package robotran.ui.program

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.click
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.swipeUp
import androidx.compose.ui.test.withKeyDown
import robotran.editing.Draft
import robotran.editing.EditKind
import robotran.editing.TextSelection
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.ui.workshop.Pane
import robotran.ui.workshop.ProgramEvent
import robotran.ui.workshop.ProgramLanguage
import robotran.ui.workshop.PupilProgram
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class ProgramPaneTest {
    private fun Workshop.write(text: String, caret: Int = text.length, anchor: Int = caret) =
        handle(ProgramEvent.Written(Draft(text, TextSelection(anchor, caret)), EditKind.OTHER))

    private val Workshop.text get() = state.programText
    private val Workshop.selected get() = state.programs.draft.selectedText
    private val Workshop.caret get() = state.programs.draft.selection.caret

    private fun ComposeUiTest.focusProgram() {
        onNodeWithTag("program").performSemanticsAction(SemanticsActions.RequestFocus)
        pass(100)
    }

    /** A finger rests on [tag]; null for its middle. */
    private fun ComposeUiTest.rest(tag: String, place: Offset? = null) {
        onNodeWithTag(tag).performTouchInput { down(place ?: center) }
        pass(800)
        onNodeWithTag(tag).performTouchInput { up() }
        pass(300)
    }

    private fun ComposeUiTest.keys(keys: List<Key>, with: Key? = null) {
        onRoot().performKeyInput {
            val press = { keys.forEach { pressKey(it) } }
            if (with == null) press() else withKeyDown(with) { press() }
        }
        pass(100)
    }

    @Test
    fun `typing writes, and a new line inside a block stands further right`() = onTablet { workshop ->
        workshop.write("repeat forever")
        pass(100)
        focusProgram()
        onNodeWithTag("program").performTextInput("\n")
        pass(100)
        onNodeWithTag("program").performTextInput("beep")
        pass(100)
        assertEquals("repeat forever\n  beep", workshop.text)
    }

    @Test
    fun `what was typed is taken back and done again, by button and by key`() = onTablet { workshop ->
        workshop.write("beep")
        pass(100)
        onNodeWithTag("redo").assertIsNotEnabled()
        onNodeWithTag("program").performTextInput(" ")
        pass(100)
        onNodeWithTag("undo").assertIsEnabled().performClick()
        pass(100)
        assertEquals("beep", workshop.text)
        onNodeWithTag("redo").performClick()
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
        assertNotEquals(true, onNodeWithTag("program").fetchSemanticsNode().config.getOrNull(SemanticsProperties.Focused))
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
        onNodeWithTag("program").performTextInput("f")
        pass(50)
        onNodeWithTag("program").performTextInput("o")
        pass(200)
        onNodeWithTag("completions").assertIsDisplayed()
        keys(listOf(Key.Enter))
        assertEquals("forward", workshop.text)
        workshop.write("tu")
        pass(100)
        onNodeWithTag("program").performTextInput("r")
        pass(200)
        onAllNodesWithText("turn").onFirst().performClick()
        pass(100)
        assertEquals("turn", workshop.text)
        assertEquals(0, onAllNodesWithTag("completions").fetchSemanticsNodes().size)
    }

    @Test
    fun `the methods of a motor are offered behind its point`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramAdded(PupilProgram("Mine.java", "Motor.A")))
        workshop.write("Motor.A")
        pass(100)
        focusProgram()
        onNodeWithTag("program").performTextInput(".")
        pass(200)
        onNodeWithText("forward()").assertIsDisplayed()
        onNodeWithText("Turns the motor forward until it is told otherwise.").assertIsDisplayed()
        keys(listOf(Key.Escape))
        assertEquals(0, onAllNodesWithTag("completions").fetchSemanticsNodes().size)
    }

    @Test
    fun `a touch on a line's number sets a breakpoint, which moves with its line`() = onTablet { workshop ->
        workshop.write("beep\nbuzz\nbeep", caret = 0)
        pass(100)
        onNodeWithTag("program").performTouchInput { click(Offset(20f, 30f)) }
        pass(300)
        assertEquals(setOf(2), workshop.state.programs.breakpoints)
        workshop.write("\nbeep\nbuzz\nbeep", caret = 1)
        assertEquals(setOf(3), workshop.state.programs.breakpoints)
        focusProgram()
        keys(listOf(Key.F9))
        assertEquals(setOf(2, 3), workshop.state.programs.breakpoints)
    }

    @Test
    fun `a mistake is told under its line when the keys rest, and mended by a button`() = onTablet { workshop ->
        workshop.write("beep\nforwrd 20")
        pass(100)
        onNodeWithText("Line 2:", substring = true).assertIsDisplayed()
        onNodeWithTag("mistakes").assertIsDisplayed()
        focusProgram()
        onNodeWithTag("program").performTextInput("0")
        pass(200)
        assertEquals(0, onAllNodesWithTag("mistake").fetchSemanticsNodes().size)
        pass(1_000)
        assertEquals(1, onAllNodesWithTag("mistake").fetchSemanticsNodes().size)
        onNodeWithTag("fix").performClick()
        pass(300)
        assertEquals("beep\nforward 200", workshop.text)
        onNodeWithTag("undo").performClick()
        assertEquals("beep\nforwrd 200", workshop.text)
    }

    @Test
    fun `the next mistake is a touch away`() = onTablet { workshop ->
        workshop.write("bep\nbeep\nbep", caret = 0)
        pass(100)
        onNodeWithTag("next-mistake").performClick()
        pass(100)
        assertEquals(9, workshop.caret)
    }

    @Test
    fun `a menu opens the search, too, also from another pane`() = onPhone { workshop ->
        workshop.handle(WorkshopEvent.PaneChosen(Pane.WORLD))
        pass(100)
        workshop.handle(ProgramEvent.FindingWanted)
        pass(300)
        onNodeWithTag("find").assertIsDisplayed()
        onNodeWithTag("find-close").performClick()
        pass(200)
        workshop.handle(ProgramEvent.FindingWanted)
        pass(300)
        onNodeWithTag("find").assertIsDisplayed()
    }

    @Test
    fun `what is found is counted, gone through and replaced`() = onTablet { workshop ->
        workshop.write("forward 20\nForward 30\nbeep", caret = 0)
        pass(100)
        onNodeWithTag("find-open").performClick()
        pass(200)
        onNodeWithTag("find").performTextInput("forward")
        pass(100)
        onNodeWithTag("find-count").assertTextEquals("0 of 2")
        onNodeWithTag("find-next").performClick()
        pass(100)
        onNodeWithTag("find-count").assertTextEquals("1 of 2")
        onNodeWithTag("find-next").performClick()
        pass(100)
        assertEquals("Forward", workshop.selected)
        onNodeWithTag("replace").performTextInput("backward")
        pass(100)
        onNodeWithTag("replace-one").performClick()
        pass(100)
        assertEquals("forward 20\nbackward 30\nbeep", workshop.text)
        onNodeWithTag("replace-all").performClick()
        pass(100)
        assertEquals("backward 20\nbackward 30\nbeep", workshop.text)
        onNodeWithTag("find-close").performClick()
        pass(100)
        assertEquals(0, onAllNodesWithTag("find-bar").fetchSemanticsNodes().size)
    }

    @Test
    fun `tidying up lays out either language`() = onTablet { workshop ->
        workshop.write("REPEAT forever\nbeep\nend")
        pass(100)
        onNodeWithTag("editor-more").performClick()
        pass(500)
        onNodeWithTag("tool-format").performClick()
        pass(500)
        assertEquals("repeat forever\n  beep\nend\n", workshop.text)
        workshop.handle(ProgramEvent.ProgramAdded(PupilProgram("A.java", "class A {\nint a;\n}")))
        workshop.handle(ProgramEvent.Formatted)
        assertEquals("class A {\n    int a;\n}\n", workshop.text)
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

    @Test
    fun `a Robolang program is shown in Java, and a line there leads to its own`() = onTablet { workshop ->
        onNodeWithTag("translation-switch").performClick()
        pass(300)
        val java = workshop.state.programs.translation?.java.orEmpty()
        onNodeWithTag("translation-text").assertTextContains("public class Square", substring = true)
        val line = java.lines().indexOfFirst { "FORWARD" in it || "forward(" in it }
        assertTrue(line >= 0, java)
        workshop.write("beep\nbep")
        pass(300)
        onNodeWithText("As it was before the mistakes").assertIsDisplayed()
        workshop.write("beep\nbuzz")
        pass(300)
        onNodeWithTag("translation-keep").performClick()
        pass(300)
        assertEquals(ProgramLanguage.JAVA, workshop.state.program.language)
    }

    @Test
    fun `one of several classes is taken away where it is renamed, and comes back`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramBegun(ProgramLanguage.JAVA))
        workshop.handle(ProgramEvent.ClassAdded)
        pass(200)
        rest("file-1")
        onNodeWithTag("remove-class").performClick()
        pass(300)
        assertEquals(1, workshop.state.program.files.size)
        onNodeWithTag("reopen-program").performClick()
        pass(300)
        assertEquals(2, workshop.state.program.files.size)
    }

    @Test
    fun `a file is renamed in its tab, a class with it`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramBegun(ProgramLanguage.JAVA))
        pass(200)
        rest("program-1")
        onNodeWithTag("rename-name").performTextReplacement("2x")
        pass(100)
        onNodeWithTag("rename-done").assertIsNotEnabled()
        onNodeWithTag("rename-name").performTextReplacement("Dancer")
        pass(100)
        onNodeWithTag("rename-done").performClick()
        pass(300)
        assertEquals("Dancer.java", workshop.state.programName)
        assertTrue("public class Dancer {" in workshop.text)
    }

    @Test
    fun `a finger puts the caret, selects a word by resting on it, and then cuts it`() = onPhone { workshop ->
        onNodeWithTag("tab-program").performClick()
        workshop.write("forward 20\nbeep\n", caret = 0)
        pass(300)
        onNodeWithTag("program").performTouchInput { click(Offset(300f, 10f)) }
        pass(400)
        assertEquals(10, workshop.caret)
        rest("program", Offset(80f, 10f))
        assertEquals("forward", workshop.selected)
        onNodeWithTag("selection-cut").performClick()
        pass(200)
        assertEquals(" 20\nbeep\n", workshop.text)
        assertEquals(0, onAllNodesWithTag("selection-bar").fetchSemanticsNodes().size)
    }

    @Test
    fun `a mouse selects by dragging and by a double click`() = onTablet { workshop ->
        workshop.write("forward 20\nbeep\n", caret = 0)
        pass(100)
        onNodeWithTag("program").performMouseInput {
            moveTo(Offset(50f, 10f))
            press()
            moveTo(Offset(60f, 10f))
            moveTo(Offset(300f, 10f))
            release()
        }
        pass(800)
        assertEquals("forward 20", workshop.selected)
        onNodeWithTag("program").performMouseInput { doubleClick(Offset(60f, 31f)) }
        pass(200)
        assertEquals("beep", workshop.selected)
    }

    @Test
    fun `a long program scrolls with a finger and is still written in where the caret is`() = onTablet { workshop ->
        val text = (1..2_000).joinToString("\n") { "forward $it" }
        workshop.write(text, caret = text.length)
        pass(300)
        onNodeWithTag("program").performTextInput("5")
        pass(300)
        assertEquals(text + "5", workshop.text)
        onNodeWithTag("program").performTouchInput { swipeUp() }
        pass(500)
        assertEquals(text + "5", workshop.text)
        onNodeWithTag("program").assertTextContains("forward 20005", substring = true)
    }
}
