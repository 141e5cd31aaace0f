package robotran.ui.screen

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertContentDescriptionContains
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.programs.Program
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.focusProgram
import robotran.ui.program.pressTool
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.DocumentTags
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examples
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopStatus
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A pupil finds NQC and works with it, on a tablet and on a phone. */
@OptIn(ExperimentalTestApi::class)
class NqcOnScreenTest {
    @Test
    fun `plus has NQC, and assembly behind more languages`() = onTablet { workshop ->
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.new(ProgramLanguage.LASM)).assertDoesNotExist()
        onNodeWithTag(ProgramTags.new(ProgramLanguage.NQC)).performClick()
        pass(300)
        assertEquals("program.nqc", workshop.state.programName)
        onNodeWithTag(ProgramTags.VIEW_SWITCH).assertDoesNotExist()
        onNodeWithText("Show assembly").assertIsDisplayed()
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.NEW_MORE).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.new(ProgramLanguage.LASM)).performClick()
        pass(300)
        assertEquals("program.lasm", workshop.state.programName)
        onNodeWithTag(ProgramTags.TRANSLATION_SWITCH).assertDoesNotExist()
    }

    @Test
    fun `a robot with an NXT has no new programs in NQC`() = onTablet { workshop ->
        workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, BrickKind.NXT))
        onNodeWithTag(ProgramTags.ADD_PROGRAM).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.new(ProgramLanguage.JAVA)).assertExists()
        onNodeWithTag(ProgramTags.new(ProgramLanguage.NQC)).assertDoesNotExist()
        onNodeWithTag(ProgramTags.NEW_MORE).assertDoesNotExist()
    }

    @Test
    fun `a mistake is told under its line and mended, and the program stops at its breakpoint`() {
        for (show in listOf(::onTablet, ::onPhone)) {
            show { workshop ->
                workshop.handle(ProgramEvent.ProgramAdded(Program.of("count.nqc", COUNTING)))
                workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                workshop.write(COUNTING.replace("OnFwd(", "OnForward("))
                pass(1_500)
                onNodeWithText("Line $DRIVING:", substring = true).assertExists()
                workshop.write(COUNTING.replace("rounds = rounds", "round = rounds"))
                pass(1_500)
                onNodeWithTag(ProgramTags.FIX).performClick()
                pass(300)
                assertEquals(COUNTING, workshop.text)
                workshop.handle(ProgramEvent.BreakpointToggled(COUNTED))
                onNodeWithTag(RunTags.RUN).performClick()
                pass(500)
                workshop.advance(2_000)
                assertEquals(WorkshopStatus.Paused(COUNTED), workshop.state.status)
                workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
                pass(500)
                onNodeWithTag(RunTags.variable("rounds")).assertTextContains("0")
            }
        }
    }

    @Test
    fun `the assembly is beside it, and a line there leads to its own`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("count.nqc", COUNTING)))
        pressTool(ProgramTags.TRANSLATION_SWITCH)
        pass(300)
        onNodeWithTag(ProgramTags.TRANSLATION_TEXT).assertTextContains("wait\t2, 100", substring = true)
        onNodeWithTag(ProgramTags.TRANSLATION_KEEP).performClick()
        pass(300)
        assertEquals("count.lasm", workshop.state.programName)
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `Robolang is beside itself in NQC, with what is different`() = onTablet { workshop ->
        workshop.write("show \"hello\"\nforward 20\n")
        onNodeWithTag(ProgramTags.EDITOR_MORE).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.translation(ShownLanguage.NQC)).performClick()
        pass(300)
        onNodeWithTag(ProgramTags.TRANSLATION_TEXT).assertTextContains("task main()", substring = true)
        onNodeWithTag(ProgramTags.TRANSLATION_REMARKS).assertIsDisplayed()
        onNodeWithTag(ProgramTags.TRANSLATION_KEEP).performClick()
        pass(300)
        assertEquals(ProgramLanguage.NQC, workshop.state.program.language)
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `a comment in assembly begins with a semicolon`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("beep.lasm", "\ttask\t0\n\tplays\t3\n\tendt\n")))
        val draft = workshop.state.programs.draft
        workshop.handle(ProgramEvent.DraftChanged(draft.withCaret(draft.text.indexOf("plays")), EditKind.OTHER))
        pass(100)
        focusProgram()
        onNodeWithTag(ProgramTags.EDITOR_MORE).performClick()
        pass(500)
        onNodeWithTag(ProgramTags.tool(EditorCommand.Plain.FORMAT)).assertDoesNotExist()
        onNodeWithTag(ProgramTags.tool(EditorCommand.Plain.TOGGLE_COMMENT)).performClick()
        pass(500)
        assertEquals("\ttask\t0\n\t; plays\t3\n\tendt\n", workshop.text)
    }

    @Test
    fun `the brick shows what NQC shows, and its datalog is a table that can be saved`() = onTablet { workshop ->
        val name = "data-logger.nqc"
        workshop.handle(ProgramEvent.ProgramAdded(Program.of(name, ProgramLanguage.NQC.examples.getValue(name))))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(8_000)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        pass(500)
        assertEquals(10, workshop.state.run.drawer.variables.datalog.size)
        onNodeWithTag(RunTags.DATALOG).assertExists()
        onNodeWithTag(RunTags.datalog(1)).assertContentDescriptionContains("Entry 1: SENSOR_2", substring = true)
        onNodeWithTag(RunTags.DATALOG_SAVE).assertExists()
        onNodeWithTag(RunTags.LCD).assertExists()
    }

    @Test
    fun `after the program its variables are still there, and the datalog names them`() = onTablet { workshop ->
        val log = "int rounds = 7;\ntask main()\n{\n    CreateDatalog(2);\n    AddToDatalog(rounds);\n}\n"
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("log.nqc", log)))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2_000)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        pass(500)
        onNodeWithTag(RunTags.variable("rounds")).assertExists()
        onNodeWithTag(RunTags.datalog(1)).assertContentDescriptionContains("Entry 1: rounds", substring = true)
    }

    @Test
    fun `the menu saves it for LEGO's firmware instead of a kit`() = onTablet { workshop ->
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("count.nqc", COUNTING)))
        pass(300)
        onNodeWithTag(DocumentTags.WORK_MENU).performClick()
        pass(300)
        onNodeWithTag(DocumentTags.menuItem(DocumentTags.MORE)).performClick()
        pass(300)
        onNodeWithText("Save for LEGO's firmware…").assertExists()
        onNodeWithText("For a real robot…").assertDoesNotExist()
        assertTrue(workshop.state.document.hasFirmwareImage)
        workshop.handle(DocumentEvent.DialogClosed)
    }

    private fun Workshop.write(text: String) = handle(ProgramEvent.DraftChanged(TextDocument(text), EditKind.OTHER))

    private companion object {
        val COUNTING = """
            int rounds = 0;

            task main()
            {
                repeat (3)
                {
                    OnFwd(OUT_A + OUT_C);
                    Wait(100);
                    rounds = rounds + 1;
                }
                Off(OUT_A + OUT_C);
            }
        """.trimIndent() + "\n"
        val DRIVING = COUNTING.lines().indexOfFirst { "OnFwd" in it } + 1
        val COUNTED = COUNTING.lines().indexOfFirst { "rounds = rounds" in it } + 1
    }
}
