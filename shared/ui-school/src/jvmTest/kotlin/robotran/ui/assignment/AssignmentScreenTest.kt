package robotran.ui.assignment

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasTestTag
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import robotran.assignments.doing.pupilCopy
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Assignment
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.documents.Machine
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.state.HandInStep
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(ExperimentalTestApi::class)
class AssignmentScreenTest {
    private var machine = newMachine()

    private fun on(
        size: Pair<Int, Int>,
        project: Project = pupilCopy(AnyAssignment.teachers),
        check: ComposeUiTest.(Workshop) -> Unit,
    ) {
        val workshop = machine.window(AnyAssignment.request(project))
        onScreenOf(workshop, size.first, size.second) { check(workshop) }
    }

    private fun Workshop.attempt(text: String) {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(20_000)
    }

    private fun ComposeUiTest.touch(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(SETTLED)
    }

    private fun ComposeUiTest.has(tag: String): Boolean = onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    @Test
    fun `the card has text, picture, due note, goals and tries on every screen`() {
        for (size in SIZES) {
            on(size) {
                for (tag in listOf("assignment-text", "assignment-picture", "assignment-due", "assignment-tries")) {
                    assertTrue(has(tag), "$tag on $size")
                }
                assertEquals(2, onAllNodesWithTag("assignment-goal").fetchSemanticsNodes().size)
            }
        }
    }

    @Test
    fun `a picture that cannot be read is its description`() {
        val broken = AnyAssignment.assignment.run { copy(pictures = pictures.map { it.copy(base64 = "AAAA") }) }
        on(TABLET, pupilCopy(AnyAssignment.teachers.copy(assignment = broken))) {
            onNodeWithTag("assignment-picture-broken").assertTextContains("This picture cannot be shown: A dot")
        }
    }

    @Test
    fun `new programs are offered in the languages of the assignment only`() {
        val only = AnyAssignment.assignment.copy(languages = listOf(ProgramLanguage.NQC))
        on(TABLET, pupilCopy(AnyAssignment.teachers.copy(assignment = only))) {
            touch("add-program")
            assertTrue(has("new-nqc"))
            for (tag in listOf("new-robolang", "new-java", "new-more", "new-lasm")) assertFalse(has(tag), tag)
        }
    }

    @Test
    fun `after a failed run its card tells the tries and leads to the hint`() = on(TABLET) { workshop ->
        workshop.attempt("beep\n")
        pass(SETTLED)
        onNodeWithTag("outcome-tries").assertTextContains("1 try. Best: 0 of 2 goals", substring = true)
        touch("missing-hint")
        assertTrue(has("hint"))
    }

    @Test
    fun `from the solved run to a file, by touch`() {
        for (size in SIZES) {
            machine = newMachine()
            on(size) { workshop ->
                workshop.attempt(AnyAssignment.SOLUTION)
                pass(SETTLED)
                touch("solved-hand-in")
                onNodeWithTag("hand-in-name").performTextInput("Ada")
                pass(SETTLED)
                touch("hand-in-go-on")
                assertIs<HandInStep.Ready>(workshop.state.handIn)
                assertTrue(has("qr-code"))
                scrollAndTouch("hand-in-file")
                scrollAndTouch("hand-in-link")
                touch("hand-in-close")
                assertNull(workshop.state.handIn)
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(SETTLED)
                onNodeWithTag("assignment-handed-in").assertTextContains("Handed in on this device as Ada.")
            }
            val saved = assertIs<ProjectFileResult.Success>(
                readProject(machine.files.disk.values.last(), Language.ENGLISH),
            ).project
            assertEquals("Ada", saved.handIn?.name)
        }
    }

    @Test
    fun `the palette has the allowed blocks only, and does not offer the others`() {
        val limited = AnyAssignment.assignment.copy(words = listOf("forward", "backward"))
        on(TABLET, pupilCopy(AnyAssignment.teachers.copy(assignment = limited))) { workshop ->
            workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
            workshop.handle(BlockEvent.DialogShown(BlockDialog.Palette))
            pass(SETTLED)
            assertTrue(has("take-move"))
            assertTrue(!has("take-turn"))
            assertTrue(!has("palette-all"))
            workshop.handle(BlockEvent.ViewChosen(ProgramView.TEXT))
            workshop.handle(ProgramEvent.ProgramEdited("forward 5\nturn left\n"))
            pass(SETTLED)
            assertTrue(has("program-not-allowed"))
        }
    }

    @Test
    fun `all that is not allowed is told below the program on every screen, and leads to its line`() {
        val limited = AnyAssignment.assignment.copy(words = listOf("forward"))
        for (size in SIZES + LOW_SIZES) {
            for (view in listOf(ProgramView.TEXT, ProgramView.BLOCKS)) {
                machine = newMachine()
                on(size, pupilCopy(AnyAssignment.teachers.copy(assignment = limited))) { workshop ->
                    workshop.handle(ProgramEvent.ProgramEdited("forward 5\nturn left 90\nbeep\n"))
                    workshop.handle(ScreenEvent.PaneChosen(Pane.PROGRAM))
                    workshop.handle(BlockEvent.ViewChosen(view))
                    pass(SETTLED)
                    val strip = hasTestTag("program-not-allowed")
                    val inStrip = hasTestTag("assignment-not-allowed") and hasAnyAncestor(strip)
                    assertEquals(2, onAllNodes(inStrip).fetchSemanticsNodes().size, "$size $view")
                    onAllNodes(inStrip)[0].performClick()
                    pass(SETTLED)
                    val draft = workshop.state.programs.draft
                    assertTrue(draft.lines.lineOf(draft.selection.caret) > 0, "$size $view")
                }
            }
        }
    }

    @Test
    fun `on a phone the task is folded from the first run on, and the pupil's choice is remembered`() = on(PHONE) {
        assertTrue(has("assignment-text"))
        it.attempt("forward 5\n")
        it.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        it.handle(ScreenEvent.TaskShown(true))
        pass(SETTLED)
        assertTrue(!has("assignment-text"))
        assertEquals(2, onAllNodesWithTag("assignment-goal").fetchSemanticsNodes().size)
        assertTrue(has("assignment-hand-in"))
        touch("task-fold")
        assertTrue(has("assignment-text"))
        it.handle(ScreenEvent.TaskShown(false))
        it.handle(ScreenEvent.TaskShown(true))
        pass(SETTLED)
        assertTrue(has("assignment-text"))
        touch("task-fold")
        assertTrue(!has("assignment-text"))
    }

    @Test
    fun `the tab of the shown program stays whole when the pane becomes narrower`() = on(1024 to 768) { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("corridor.robo", "forward 5\n")))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("solution.robo", "forward 5\n")))
        pass(SETTLED)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.TEXT))
        pass(SETTLED)
        val tab = onNodeWithTag("close-program").fetchSemanticsNode()
        assertEquals(tab.size.width.toFloat(), tab.boundsInRoot.width, 1f)
        assertTrue(tab.boundsInRoot.right <= onNodeWithTag("add-program").fetchSemanticsNode().boundsInRoot.left + 1)
    }

    @Test
    fun `only one card tells the tries`() {
        for (size in SIZES) {
            machine = newMachine()
            on(size) { workshop ->
                workshop.attempt("beep\n")
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                pass(SETTLED)
                touch("missing-hint")
                assertTrue(has("hint"), "$size")
                val described = listOf("outcome-tries", "assignment-tries").count { has(it) }
                assertEquals(1, described, "$size")
            }
        }
    }

    @Test
    fun `who has tried nothing is told so when handing in`() = on(TABLET) { workshop ->
        touch("assignment-hand-in")
        onNodeWithTag("hand-in-what").assertTextContains("You have not tried anything yet.", substring = true)
        assertTrue(has("hand-in-unchanged"))
        workshop.handle(AssignmentEvent.HandInClosed)
        workshop.handle(ProgramEvent.ProgramEdited("forward 5\n"))
        workshop.handle(AssignmentEvent.HandInRequested)
        pass(SETTLED)
        assertTrue(!has("hand-in-unchanged"))
    }

    @Test
    fun `the code of a hand-in can be seen whole on phones, also with large text`() {
        for (size in LOW_SIZES) {
            for (scale in listOf(1f, 2f)) {
                machine = newMachine()
                on(size) { workshop ->
                    workshop.handle(SettingsEvent.SettingsChanged(Settings(lessMotion = true, textScale = scale)))
                    workshop.attempt(AnyAssignment.SOLUTION)
                    workshop.handle(AssignmentEvent.HandInRequested)
                    workshop.handle(AssignmentEvent.NameEntered("Ada"))
                    workshop.handle(AssignmentEvent.HandInMade())
                    pass(SETTLED)
                    scrollTo("qr-code")
                    val node = onNodeWithTag("qr-code").fetchSemanticsNode()
                    val shown = node.boundsInRoot
                    assertEquals(node.size.width, node.size.height, "$size at $scale")
                    assertEquals(node.size.height.toFloat(), shown.height, 1f, "$size at $scale")
                    assertTrue(shown.height > 180, "$size at $scale: ${shown.height}")
                    touch("qr-code")
                    val large = onNodeWithTag("qr-code-large").fetchSemanticsNode()
                    assertTrue(large.size.height >= minOf(size.first, size.second) - 1, "$size at $scale")
                    touch("qr-large-close")
                    assertTrue(!has("qr-code-large"))
                }
            }
        }
    }

    @Test
    fun `the menu of the project opens the page, which makes hints`() = on(TABLET, AnyAssignment.teachers) { workshop ->
        touch("work-menu")
        touch("work-make-assignment")
        assertTrue(has("assignment-make"))
        val before = assignmentOf(workshop).hints.size
        scrollAndTouch("make-hint-add")
        onNodeWithTag("make-hint-text-$before").performTextInput("Look at the start.")
        pass(SETTLED)
        assertEquals("Look at the start.", assignmentOf(workshop).hints.last().text)
        scrollAndTouch("make-hint-later-$before")
        assertEquals(2, assignmentOf(workshop).hints.last().afterTries)
        scrollAndTouch("make-undo")
        assertEquals(1, assignmentOf(workshop).hints.last().afterTries)
        touch("assignment-make-close")
        assertNull(workshop.state.making)
    }

    @Test
    fun `back closes the page`() = on(PHONE, AnyAssignment.teachers) { workshop ->
        workshop.handle(AssignmentEvent.MakingRequested)
        pass(SETTLED)
        assertNotNull(workshop.state.making)
        touch("assignment-make-close")
        assertNull(workshop.state.making)
    }

    private fun newMachine() = Machine().apply { files.location = "/home/hand-in.robotran" }

    private fun assignmentOf(workshop: Workshop): Assignment = checkNotNull(workshop.project.assignment)

    private companion object {
        const val SETTLED = 300L
        val PHONE = 411 to 891
        val TABLET = 1280 to 800
        val LOW_SIZES = listOf(360 to 740, 640 to 360)
        val SIZES = listOf(PHONE, 800 to 1280, TABLET, 1440 to 900)
    }
}
