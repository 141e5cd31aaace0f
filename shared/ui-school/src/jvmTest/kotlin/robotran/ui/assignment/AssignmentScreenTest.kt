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
import robotran.ui.program.tags.ProgramTags
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.ui.screen.tags.ScreenTags
import robotran.uikit.KitTags
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
                for (tag in listOf(
                    AssignmentTags.ASSIGNMENT_TEXT,
                    AssignmentTags.ASSIGNMENT_PICTURE,
                    AssignmentTags.ASSIGNMENT_DUE,
                    AssignmentTags.ASSIGNMENT_TRIES,
                )) {
                    assertTrue(has(tag), "$tag on $size")
                }
                assertEquals(2, onAllNodesWithTag(AssignmentTags.ASSIGNMENT_GOAL).fetchSemanticsNodes().size)
            }
        }
    }

    @Test
    fun `a picture that cannot be read is its description`() {
        val broken = AnyAssignment.assignment.run { copy(pictures = pictures.map { it.copy(base64 = "AAAA") }) }
        on(TABLET, pupilCopy(AnyAssignment.teachers.copy(assignment = broken))) {
            onNodeWithTag(AssignmentTags.ASSIGNMENT_PICTURE_BROKEN)
                .assertTextContains("This picture cannot be shown: A dot")
        }
    }

    @Test
    fun `new programs are offered in the languages of the assignment only`() {
        val only = AnyAssignment.assignment.copy(languages = listOf(ProgramLanguage.NQC))
        on(TABLET, pupilCopy(AnyAssignment.teachers.copy(assignment = only))) {
            touch(ProgramTags.ADD_PROGRAM)
            assertTrue(has(ProgramTags.new(ProgramLanguage.NQC)))
            for (tag in listOf(
                ProgramTags.new(ProgramLanguage.ROBOLANG),
                ProgramTags.new(ProgramLanguage.JAVA),
                ProgramTags.NEW_MORE,
                ProgramTags.new(ProgramLanguage.LASM),
            )) {
                assertFalse(has(tag), tag)
            }
        }
    }

    @Test
    fun `after a failed run the task tells the tries and has the hint`() = on(TABLET) { workshop ->
        workshop.attempt("beep\n")
        pass(SETTLED)
        onNodeWithTag(
            AssignmentTags.ASSIGNMENT_TRIES,
        ).assertTextContains("1 try. Best: 0 of 2 goals", substring = true)
        assertTrue(has(LearningTags.HINT) && has(ScreenTags.MISSING_CARD))
    }

    @Test
    fun `from the solved run to a file, by touch`() {
        for (size in SIZES) {
            machine = newMachine()
            on(size) { workshop ->
                workshop.attempt(AnyAssignment.SOLUTION)
                pass(SETTLED)
                scrollAndTouch(ScreenTags.SOLVED_HAND_IN)
                onNodeWithTag(AssignmentTags.HAND_IN_NAME).performTextInput("Ada")
                pass(SETTLED)
                touch(AssignmentTags.HAND_IN_GO_ON)
                assertIs<HandInStep.Ready>(workshop.state.handIn)
                assertTrue(has(DocumentTags.QR_CODE))
                scrollAndTouch(AssignmentTags.HAND_IN_FILE)
                scrollAndTouch(AssignmentTags.HAND_IN_LINK)
                touch(AssignmentTags.HAND_IN_CLOSE)
                assertNull(workshop.state.handIn)
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(SETTLED)
                onNodeWithTag(AssignmentTags.ASSIGNMENT_HANDED_IN)
                    .assertTextContains("Handed in on this device as Ada.")
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
            assertTrue(has(ProgramTags.take("move")))
            assertTrue(!has(ProgramTags.take("turn")))
            assertTrue(!has(ProgramTags.PALETTE_ALL))
            workshop.handle(BlockEvent.ViewChosen(ProgramView.TEXT))
            workshop.handle(ProgramEvent.ProgramEdited("forward 5\nturn left\n"))
            pass(SETTLED)
            assertTrue(has(AssignmentTags.PROGRAM_NOT_ALLOWED))
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
                    val strip = hasTestTag(AssignmentTags.PROGRAM_NOT_ALLOWED)
                    val inStrip = hasTestTag(AssignmentTags.ASSIGNMENT_NOT_ALLOWED) and hasAnyAncestor(strip)
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
        assertTrue(has(AssignmentTags.ASSIGNMENT_TEXT))
        it.attempt("forward 5\n")
        it.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        it.handle(ScreenEvent.TaskShown(true))
        pass(SETTLED)
        assertTrue(!has(AssignmentTags.ASSIGNMENT_TEXT))
        assertEquals(2, onAllNodesWithTag(AssignmentTags.ASSIGNMENT_GOAL).fetchSemanticsNodes().size)
        assertTrue(has(AssignmentTags.ASSIGNMENT_HAND_IN))
        touch(AssignmentTags.TASK_FOLD)
        assertTrue(has(AssignmentTags.ASSIGNMENT_TEXT))
        it.handle(ScreenEvent.TaskShown(false))
        it.handle(ScreenEvent.TaskShown(true))
        pass(SETTLED)
        assertTrue(has(AssignmentTags.ASSIGNMENT_TEXT))
        touch(AssignmentTags.TASK_FOLD)
        assertTrue(!has(AssignmentTags.ASSIGNMENT_TEXT))
    }

    @Test
    fun `the tab of the shown program stays whole when the pane becomes narrower`() = on(1024 to 768) { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("corridor.robo", "forward 5\n")))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("solution.robo", "forward 5\n")))
        pass(SETTLED)
        workshop.handle(BlockEvent.ViewChosen(ProgramView.TEXT))
        pass(SETTLED)
        val tab = onNodeWithTag(ProgramTags.CLOSE_PROGRAM).fetchSemanticsNode()
        assertEquals(tab.size.width.toFloat(), tab.boundsInRoot.width, 1f)
        assertTrue(
            tab.boundsInRoot.right <= onNodeWithTag(ProgramTags.ADD_PROGRAM).fetchSemanticsNode().boundsInRoot.left + 1,
        )
    }

    @Test
    fun `only one card tells the tries`() {
        for (size in SIZES) {
            machine = newMachine()
            on(size) { workshop ->
                workshop.attempt("beep\n")
                workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
                pass(SETTLED)
                assertTrue(has(LearningTags.HINT), "$size")
                val described = listOf(ScreenTags.OUTCOME_TRIES, AssignmentTags.ASSIGNMENT_TRIES).count { has(it) }
                assertEquals(1, described, "$size")
            }
        }
    }

    @Test
    fun `who has tried nothing is told so when handing in`() = on(TABLET) { workshop ->
        touch(AssignmentTags.ASSIGNMENT_HAND_IN)
        onNodeWithTag(AssignmentTags.HAND_IN_WHAT)
            .assertTextContains("You have not tried anything yet.", substring = true)
        assertTrue(has(AssignmentTags.HAND_IN_UNCHANGED))
        workshop.handle(AssignmentEvent.HandInClosed)
        workshop.handle(ProgramEvent.ProgramEdited("forward 5\n"))
        workshop.handle(AssignmentEvent.HandInRequested)
        pass(SETTLED)
        assertTrue(!has(AssignmentTags.HAND_IN_UNCHANGED))
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
                    scrollTo(DocumentTags.QR_CODE)
                    val node = onNodeWithTag(DocumentTags.QR_CODE).fetchSemanticsNode()
                    val shown = node.boundsInRoot
                    assertEquals(node.size.width, node.size.height, "$size at $scale")
                    assertEquals(node.size.height.toFloat(), shown.height, 1f, "$size at $scale")
                    assertTrue(shown.height > 180, "$size at $scale: ${shown.height}")
                    touch(DocumentTags.QR_CODE)
                    val large = onNodeWithTag(DocumentTags.QR_CODE_LARGE).fetchSemanticsNode()
                    assertTrue(large.size.height >= minOf(size.first, size.second) - 1, "$size at $scale")
                    touch(DocumentTags.QR_LARGE_CLOSE)
                    assertTrue(!has(DocumentTags.QR_CODE_LARGE))
                }
            }
        }
    }

    @Test
    fun `what is for teachers opens the page, which makes hints`() = on(TABLET, AnyAssignment.teachers) { workshop ->
        touch(ScreenTags.MENU)
        touch(ScreenTags.MENU_TEACHERS)
        touch(LearningTags.TEACHERS_MAKE)
        assertTrue(has(AssignmentTags.ASSIGNMENT_MAKE))
        val before = assignmentOf(workshop).hints.size
        scrollAndTouch(AssignmentTags.MAKE_HINT_ADD)
        onNodeWithTag(AssignmentTags.makeHintText(before)).performTextInput("Look at the start.")
        pass(SETTLED)
        assertEquals("Look at the start.", assignmentOf(workshop).hints.last().text)
        scrollAndTouch(AssignmentTags.makeHintLater(before))
        assertEquals(2, assignmentOf(workshop).hints.last().afterTries)
        scrollAndTouch(AssignmentTags.MAKE_UNDO)
        assertEquals(1, assignmentOf(workshop).hints.last().afterTries)
        touch(KitTags.close(AssignmentTags.ASSIGNMENT_MAKE))
        assertNull(workshop.state.making)
    }

    @Test
    fun `back closes the page`() = on(PHONE, AnyAssignment.teachers) { workshop ->
        workshop.handle(AssignmentEvent.MakingRequested)
        pass(SETTLED)
        assertNotNull(workshop.state.making)
        touch(KitTags.close(AssignmentTags.ASSIGNMENT_MAKE))
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
