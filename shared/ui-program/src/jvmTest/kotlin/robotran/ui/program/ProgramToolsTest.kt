package robotran.ui.program

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.robolang.words.Vocabulary
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.onPhone
import robotran.ui.screen.onTablet
import robotran.ui.screen.pass
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.NoteKind
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests the program tools: diagnostics, search, formatting, translation. */
@OptIn(ExperimentalTestApi::class)
class ProgramToolsTest {
    @Test
    fun `a mistake is told under its line when the keys rest, and mended by a button`() = onTablet { workshop ->
        workshop.write("beep\nforwrd 20")
        pass(100)
        onNodeWithText("Line 2:", substring = true).assertIsDisplayed()
        onNodeWithTag(ProgramTags.MISTAKES).assertIsDisplayed()
        focusProgram()
        onNodeWithTag(ProgramTags.PROGRAM).performTextInput("0")
        pass(200)
        assertEquals(0, onAllNodesWithTag(ProgramTags.note(NoteKind.ERROR)).fetchSemanticsNodes().size)
        pass(1_000)
        assertEquals(1, onAllNodesWithTag(ProgramTags.note(NoteKind.ERROR)).fetchSemanticsNodes().size)
        onNodeWithTag(ProgramTags.FIX).performClick()
        pass(300)
        assertEquals("beep\nforward 200", workshop.text)
        onNodeWithTag(ProgramTags.UNDO).performClick()
        assertEquals("beep\nforwrd 200", workshop.text)
    }

    @Test
    fun `the next mistake is a touch away`() = onTablet { workshop ->
        workshop.write("bep\nbeep\nbep", caret = 0)
        pass(100)
        onNodeWithTag(ProgramTags.NEXT_MISTAKE).performClick()
        pass(100)
        assertEquals(9, workshop.caret)
    }

    @Test
    fun `a menu opens the search, too, also from another pane`() = onPhone { workshop ->
        workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        pass(100)
        workshop.handle(ProgramEvent.SearchRequested)
        pass(300)
        onNodeWithTag(ProgramTags.FIND).assertIsDisplayed()
        onNodeWithTag(ProgramTags.FIND_CLOSE).performClick()
        pass(200)
        workshop.handle(ProgramEvent.SearchRequested)
        pass(300)
        onNodeWithTag(ProgramTags.FIND).assertIsDisplayed()
    }

    @Test
    fun `what is found is counted, gone through and replaced`() = onTablet { workshop ->
        workshop.write("forward 20\nForward 30\nbeep", caret = 0)
        pass(100)
        onNodeWithTag(ProgramTags.FIND_OPEN).performClick()
        pass(200)
        onNodeWithTag(ProgramTags.FIND).performTextInput("forward")
        pass(100)
        onNodeWithTag(ProgramTags.FIND_COUNT).assertTextEquals("0 of 2")
        onNodeWithTag(ProgramTags.FIND_NEXT).performClick()
        pass(100)
        onNodeWithTag(ProgramTags.FIND_COUNT).assertTextEquals("1 of 2")
        onNodeWithTag(ProgramTags.FIND_NEXT).performClick()
        pass(100)
        assertEquals("Forward", workshop.selected)
        onNodeWithTag(ProgramTags.REPLACE).performTextInput("backward")
        pass(100)
        onNodeWithTag(ProgramTags.REPLACE_ONE).performClick()
        pass(100)
        assertEquals("forward 20\nbackward 30\nbeep", workshop.text)
        onNodeWithTag(ProgramTags.REPLACE_ALL).performClick()
        pass(100)
        assertEquals("backward 20\nbackward 30\nbeep", workshop.text)
        onNodeWithTag(ProgramTags.FIND_CLOSE).performClick()
        pass(100)
        assertEquals(0, onAllNodesWithTag(ProgramTags.FIND_BAR).fetchSemanticsNodes().size)
    }

    @Test
    fun `tidying up lays out either language`() = onTablet { workshop ->
        workshop.write("REPEAT forever\nbeep\nend")
        pass(100)
        onNodeWithTag(ProgramTags.EDITOR_MORE).performClick()
        pass(500)
        onNodeWithTag(ProgramTags.tool(EditorCommand.Plain.FORMAT)).performClick()
        pass(500)
        assertEquals("repeat forever\n  beep\nend\n", workshop.text)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("A.java", "class A {\nint a;\n}")))
        workshop.handle(ProgramEvent.Formatted)
        assertEquals("class A {\n    int a;\n}\n", workshop.text)
    }

    @Test
    fun `a Robolang program is shown in Java, and a line there leads to its own`() = onTablet { workshop ->
        pressTool(ProgramTags.TRANSLATION_SWITCH)
        pass(300)
        val java = workshop.state.programs.translation?.text.orEmpty()
        onNodeWithTag(ProgramTags.TRANSLATION_TEXT).assertTextContains("public class Square", substring = true)
        val line = java.lines().indexOfFirst { "FORWARD" in it || "forward(" in it }
        assertTrue(line >= 0, java)
        workshop.write("beep\nbep")
        pass(300)
        onNodeWithText("As it was before the mistakes").assertIsDisplayed()
        workshop.write("beep\nbuzz")
        pass(300)
        onNodeWithTag(ProgramTags.TRANSLATION_KEEP).performClick()
        pass(300)
        assertEquals(ProgramLanguage.JAVA, workshop.state.program.language)
    }

    @Test
    fun `the menu writes the program in the words of another language, and undo takes that back`() =
        onTablet { workshop ->
            workshop.handle(SettingsEvent.SettingsChanged(Settings(language = Language.GERMAN)))
            workshop.write("repeat 4 times\n  forward 20\nend")
            pass(100)
            onNodeWithTag(ProgramTags.EDITOR_MORE).performClick()
            pass(100)
            onNodeWithTag(ProgramTags.words(Language.GERMAN)).performClick()
            pass(1_000)
            assertEquals("wiederhole 4 mal\n  vorwärts 20\nende", workshop.text)
            assertEquals(0, onAllNodesWithTag(ProgramTags.note(NoteKind.ERROR)).fetchSemanticsNodes().size)
            onNodeWithTag(ProgramTags.UNDO).performClick()
            assertEquals("repeat 4 times\n  forward 20\nend", workshop.text)
        }

    @Test
    fun `names that are words of the other language are told, and the program stays`() = onTablet { workshop ->
        workshop.write("var ende = 5\nshow ende")
        workshop.handle(ProgramEvent.WordsChosen(Vocabulary.of(Language.GERMAN)))
        pass(100)
        assertEquals("var ende = 5\nshow ende", workshop.text)
        assertEquals(Notice.NamesInTheWay(Language.GERMAN, listOf("ende")), workshop.state.notice)
    }
}
