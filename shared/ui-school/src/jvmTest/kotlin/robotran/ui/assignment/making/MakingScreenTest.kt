package robotran.ui.assignment.making

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsNotSelected
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.swipe
import androidx.compose.ui.unit.toSize
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.projects.ProjectRobot
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.ui.screen.touch
import robotran.ui.world.tags.WorldTags
import robotran.uikit.KitTags
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.documents.Machine
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.state.Pane
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** The page that makes an assignment, by touch. */
@OptIn(ExperimentalTestApi::class)
class MakingScreenTest {
    private val machine = Machine().apply { files.location = "/home/made.robotran" }

    private fun making(
        size: Pair<Int, Int>,
        project: Project = AnyAssignment.teachers,
        check: ComposeUiTest.(Workshop) -> Unit,
    ) {
        // My work asks about a file whose changes it keeps from the size before, so each size has a file of its own.
        val file = AnyAssignment.file(project, "circle-${size.first}.robotran")
        val workshop = machine.window(OpenRequest.OfFiles(listOf(file)))
        workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(site = "https://school.example/")))
        workshop.handle(AssignmentEvent.MakingRequested)
        onScreenOf(workshop, size.first, size.second) { check(workshop) }
    }

    private fun ComposeUiTest.has(tag: String): Boolean = onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    private fun ComposeUiTest.placeOf(tag: String): Rect =
        onNodeWithTag(tag).fetchSemanticsNode().let { Rect(it.positionInRoot, it.size.toSize()) }

    /** Whether all of [tag] is in sight, and announced. */
    private fun ComposeUiTest.assertSeenAndAnnounced(tag: String) {
        val form = onNodeWithTag(AssignmentTags.MAKE_FORM).fetchSemanticsNode().boundsInRoot
        val place = placeOf(tag)
        assertTrue(place.top >= form.top && place.bottom <= form.bottom, "$tag at $place is not in sight in $form")
        val described = onNodeWithTag(tag).fetchSemanticsNode().config.getOrNull(SemanticsProperties.LiveRegion)
        assertNotNull(described, "$tag is not announced")
    }

    private fun assignmentOf(workshop: Workshop): Assignment = checkNotNull(workshop.project.assignment)

    @Test
    fun `the programs of the solution are ticked and unticked`() {
        val programs = listOf(AnyAssignment.program(AnyAssignment.BEGIN), AnyAssignment.program("beep\n", "two.robo"))
        val robot = ProjectRobot(AnyAssignment.world.robots.first().name, programs)
        for (size in SIZES) {
            making(size, AnyAssignment.teachers.copy(robots = listOf(robot))) { workshop ->
                scrollAndTouch(AssignmentTags.makeSolution(1))
                assertEquals(listOf("circle.robo", "two.robo"), assignmentOf(workshop).solution.map { it.name })
                assertTrue(has(AssignmentTags.MAKE_SOLUTION_FIRST))
                scrollAndTouch(AssignmentTags.makeSolution(0))
                assertEquals(listOf("two.robo"), assignmentOf(workshop).solution.map { it.name })
                val state = onNodeWithTag(AssignmentTags.makeSolution(0)).fetchSemanticsNode().config
                assertEquals(ToggleableState.Off, state[SemanticsProperties.ToggleableState])
            }
        }
    }

    @Test
    fun `the choice of programs to begin with says that nothing is chosen, and refuses the solution`() {
        val programs = listOf(AnyAssignment.program(AnyAssignment.SOLUTION, "program.robo"))
        val robot = ProjectRobot(AnyAssignment.world.robots.first().name, programs)
        for (size in SIZES) {
            making(size, AnyAssignment.teachers.copy(robots = listOf(robot))) {
                scrollTo(AssignmentTags.MAKE_START_EMPTY)
                onNodeWithTag(AssignmentTags.MAKE_START_EMPTY)
                    .assertTextContains("begin with an empty program: program.robo", true)
                assertTrue(!has(AssignmentTags.MAKE_START_REFUSED))
                scrollAndTouch(AssignmentTags.makeStart(0))
                onNodeWithTag(AssignmentTags.makeStart(0)).assertIsNotSelected()
                onNodeWithTag(AssignmentTags.MAKE_START_REFUSED)
                    .assertTextContains("program.robo is the solution", true)
                assertSeenAndAnnounced(AssignmentTags.MAKE_START_REFUSED)
            }
        }
    }

    @Test
    fun `back from a variation and from trying, the page is where it was`() {
        for (size in SIZES) {
            making(size) { workshop ->
                scrollTo(AssignmentTags.makeVariationOpen(0))
                val before = placeOf(AssignmentTags.makeVariationOpen(0))
                touch(AssignmentTags.makeVariationOpen(0))
                onNodeWithTag(WorldTags.EDIT_OF_ASSIGNMENT_WORDS)
                    .assertTextContains("Variation “Small” of the assignment “Into the circle”", substring = true)
                assertTrue(!has(WorldTags.EDIT_TRY))
                touch(WorldTags.EDIT_TO_ASSIGNMENT)
                assertEquals(before, placeOf(AssignmentTags.makeVariationOpen(0)))
                touch(KitTags.close(AssignmentTags.ASSIGNMENT_MAKE))
                assertNull(workshop.state.making)
                workshop.handle(AssignmentEvent.MakingRequested)
                pass(300)
                assertEquals(before, placeOf(AssignmentTags.makeVariationOpen(0)))
                touch(KitTags.close(AssignmentTags.ASSIGNMENT_MAKE))
                workshop.handle(WorldEditEvent.EditorOpened)
                pass(300)
                assertTrue(!has(WorldTags.EDIT_OF_ASSIGNMENT))
                assertTrue(has(WorldTags.EDIT_TRY))
            }
        }
    }

    @Test
    fun `another assignment begins at the top`() = making(PHONE) { workshop ->
        scrollTo(AssignmentTags.MAKE_REMOVE)
        workshop.handle(AssignmentEvent.Removed)
        pass(300)
        workshop.handle(AssignmentEvent.MakingRequested)
        pass(300)
        assertTrue(placeOf(AssignmentTags.MAKE_TITLE).top in 0f..PHONE.second.toFloat())
    }

    @Test
    fun `the page scrolls by a finger beside its column, too`() = making(TABLET) {
        assertEquals(0f, scrolled())
        onRoot().performTouchInput { swipe(Offset(30f, height - 100f), Offset(30f, 200f), 200) }
        pass(1000)
        assertTrue(scrolled() > 200f)
    }

    private fun ComposeUiTest.scrolled(): Float = onNodeWithTag(AssignmentTags.MAKE_FORM)
        .fetchSemanticsNode().config[SemanticsProperties.VerticalScrollAxisRange].value()

    @Test
    fun `results of the check, of link and of saving come into view and are announced`() {
        for (size in SIZES) {
            making(size) { workshop ->
                scrollAndTouch(AssignmentTags.MAKE_CHECK)
                pass(500)
                assertSeenAndAnnounced(AssignmentTags.MAKE_CHECKED)
                scrollAndTouch(AssignmentTags.MAKE_PUPIL_FILE)
                pass(500)
                assertSeenAndAnnounced(AssignmentTags.MAKE_SAVED)
                scrollAndTouch(AssignmentTags.MAKE_PUPIL_LINK)
                pass(500)
                assertTrue(has(DocumentTags.QR_CODE))
                val form = onNodeWithTag(AssignmentTags.MAKE_FORM).fetchSemanticsNode().boundsInRoot
                val code = placeOf(DocumentTags.QR_CODE)
                assertTrue(code.top >= form.top && code.bottom <= form.bottom)
                scrollAndTouch(AssignmentTags.linkCopy(AssignmentTags.MAKE))
                assertEquals(true, workshop.state.making?.link?.isCopied)
            }
        }
    }

    @Test
    fun `the code for a web page is shown and told to be copied`() {
        for (size in SIZES) {
            making(size) { workshop ->
                scrollAndTouch(AssignmentTags.MAKE_EMBED)
                pass(500)
                assertSeenAndAnnounced(AssignmentTags.MAKE_EMBED_COPIED)
                onNodeWithTag(AssignmentTags.MAKE_EMBED_COPIED).assertTextContains("Code copied")
                onNodeWithTag(AssignmentTags.MAKE_EMBED_CODE).assertTextContains("<iframe src=", substring = true)
                assertEquals(machine.clipboard.text, workshop.state.making?.embedCode)
                assertTrue(!has(DocumentTags.LINK_LOCAL))
            }
        }
    }

    @Test
    fun `links and codes that begin with localhost say that they work on this machine only`() {
        machine.page = "http://localhost:8282/"
        making(PHONE) {
            scrollAndTouch(AssignmentTags.MAKE_EMBED)
            pass(500)
            onNodeWithTag(DocumentTags.LINK_LOCAL).assertTextContains("localhost:8282 and works on this machine", true)
        }
        making(PHONE) {
            scrollAndTouch(AssignmentTags.MAKE_PUPIL_LINK)
            pass(500)
            onNodeWithTag(DocumentTags.LINK_LOCAL).assertTextContains("localhost:8282 and works on this machine", true)
        }
    }

    @Test
    fun `the check tells of a program to begin with that already reaches the goals`() {
        val begun = AnyAssignment.program("beep\n" + AnyAssignment.SOLUTION)
        val robot = ProjectRobot(AnyAssignment.world.robots.first().name, listOf(begun))
        making(TABLET, AnyAssignment.teachers.copy(robots = listOf(robot))) {
            scrollAndTouch(AssignmentTags.MAKE_CHECK)
            pass(500)
            onNodeWithTag(AssignmentTags.MAKE_CHECKED_START)
                .assertTextContains("already reaches the goals in 6 of 6 runs", true)
        }
    }

    @Test
    fun `the code for a class fills the screen, and Escape or the button closes it`() {
        for (size in SIZES) {
            making(size) {
                scrollAndTouch(AssignmentTags.MAKE_PUPIL_LINK)
                scrollAndTouch(DocumentTags.QR_SHOW_LARGE)
                val side = placeOf(DocumentTags.QR_CODE_LARGE).width
                assertTrue(side >= minOf(size.first, size.second) - 1, "$side on $size")
                onNodeWithTag(DocumentTags.QR_LARGE_CLOSE).performKeyInput { pressKey(Key.Escape) }
                pass(300)
                assertTrue(!has(DocumentTags.QR_LARGE_VIEW))
                scrollAndTouch(DocumentTags.QR_SHOW_LARGE)
                touch(DocumentTags.QR_LARGE_CLOSE)
                assertTrue(!has(DocumentTags.QR_LARGE_VIEW))
            }
        }
    }

    @Test
    fun `a link that is too long for a code says what to do`() {
        val random = Random(7)
        val text = (1..200).joinToString("\n") { random.nextLong().toString(36) }
        making(PHONE, AnyAssignment.teachers.copy(assignment = AnyAssignment.assignment.copy(text = text))) {
            scrollAndTouch(AssignmentTags.MAKE_PUPIL_LINK)
            onNodeWithTag(DocumentTags.QR_TOO_LONG).assertTextContains("give pupils the file", substring = true)
            assertTrue(!has(DocumentTags.QR_SHOW_LARGE))
            assertTrue(has(AssignmentTags.linkCopy(AssignmentTags.MAKE)))
        }
    }

    @Test
    fun `the number of seeds is typed or chosen`() = making(PHONE) { workshop ->
        scrollTo(AssignmentTags.MAKE_SEEDS)
        onNodeWithTag(AssignmentTags.MAKE_SEEDS).performTextReplacement("37")
        pass(300)
        assertEquals(1..37, assignmentOf(workshop).checks?.seeds)
        onNodeWithTag(AssignmentTags.MAKE_SEEDS).performTextReplacement("0")
        pass(300)
        assertTrue(has(AssignmentTags.MAKE_SEEDS_WRONG))
        onNodeWithTag(AssignmentTags.MAKE_SEEDS).performTextReplacement("101")
        pass(300)
        assertTrue(has(AssignmentTags.MAKE_SEEDS_WRONG))
        assertEquals(1..37, assignmentOf(workshop).checks?.seeds)
        scrollAndTouch(AssignmentTags.makeSeeds(20))
        onNodeWithTag(AssignmentTags.makeSeeds(20)).assertIsSelected()
        assertEquals(1..20, assignmentOf(workshop).checks?.seeds)
        assertTrue(!has(AssignmentTags.MAKE_SEEDS_WRONG))
        workshop.handle(AssignmentEvent.UndoRequested)
        pass(300)
        onNodeWithTag(AssignmentTags.MAKE_SEEDS).assertTextContains("37")
    }

    @Test
    fun `condition and number of tries of a new hint can be chosen before its text`() = making(PHONE) { workshop ->
        val index = assignmentOf(workshop).hints.size
        scrollAndTouch(AssignmentTags.MAKE_HINT_ADD)
        assertTrue(has(AssignmentTags.makeHintWhen(index)))
        scrollAndTouch(AssignmentTags.makeHintLater(index))
        onNodeWithTag(AssignmentTags.makeHintAfter(index)).assertTextContains("After 2 failed tries")
        assertEquals(index, assignmentOf(workshop).hints.size)
        scrollTo(AssignmentTags.makeHintText(index))
        onNodeWithTag(AssignmentTags.makeHintText(index)).performTextInput("Look.")
        pass(300)
        assertEquals("Look." to 2, assignmentOf(workshop).hints.last().run { text to afterTries })
    }

    @Test
    fun `the card of the teacher's file leads to the hand-ins`() = making(TABLET) { workshop ->
        touch(KitTags.close(AssignmentTags.ASSIGNMENT_MAKE))
        workshop.handle(ScreenEvent.PaneChosen(Pane.WORLD))
        workshop.handle(ScreenEvent.TaskShown(true))
        pass(300)
        touch(AssignmentTags.ASSIGNMENT_HAND_INS)
        assertNotNull(workshop.state.handIns)
    }

    private companion object {
        val PHONE = 360 to 740
        val TABLET = 1024 to 768
        val SIZES = listOf(PHONE, TABLET, 768 to 1024, 1280 to 800)
    }
}
