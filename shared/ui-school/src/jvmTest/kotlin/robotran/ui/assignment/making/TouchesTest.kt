package robotran.ui.assignment.making

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performScrollToKey
import androidx.compose.ui.test.performTextInput
import robotran.language.Language
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.scrollTo
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.touch
import robotran.ui.world.tags.WorldTags
import robotran.uikit.KitTags
import robotran.workshop.Workshop
import robotran.workshop.documents.Machine
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.SolutionCheck
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.test.Test
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** How many touches the assignment of docs/teachers.md takes: each tap, each field, each drag and each swipe. */
@OptIn(ExperimentalTestApi::class)
class TouchesTest {
    private var touches = 0

    private fun ComposeUiTest.topOf(tag: String) = onNodeWithTag(tag).fetchSemanticsNode().positionInRoot.y

    /** Swipes by three quarters of the screen until [tag] is in sight. */
    private fun ComposeUiTest.swipeTo(tag: String, height: Int) {
        val before = topOf(tag)
        scrollTo(tag)
        touches += ceil(abs(topOf(tag) - before) / (height * SWIPE)).toInt()
    }

    private fun ComposeUiTest.tap(tag: String, height: Int) {
        swipeTo(tag, height)
        touch(tag)
        pass(500)
        touches++
    }

    private fun ComposeUiTest.has(tag: String) = onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    /** Types a program on a screen where the program may be another page. */
    private fun ComposeUiTest.program(workshop: Workshop, text: String) {
        if (has(ScreenTags.tab(Pane.PROGRAM))) tap(ScreenTags.tab(Pane.PROGRAM), 1_000)
        workshop.handle(ProgramEvent.ProgramEdited(text))
        pass(300)
        touches++
    }

    private fun ComposeUiTest.makeAssignment(height: Int) {
        tap(ScreenTags.MENU, height)
        tap(ScreenTags.MENU_TEACHERS, height)
        tap(LearningTags.TEACHERS_MAKE, height)
    }

    private fun count(width: Int, height: Int): Pair<Int, Int> {
        touches = 0
        val machine = Machine().apply { files.location = "/home/maze.robotran" }
        val workshop = machine.window()
        var first = 0
        onScreenOf(workshop, width, height) {
            if (has(ScreenTags.WORLDS)) {
                tap(ScreenTags.WORLDS, height)
            } else {
                tap(ScreenTags.MENU, height)
                tap(ScreenTags.MENU_WORLDS, height)
            }
            onNodeWithTag(LearningTags.WORLD_CARDS).performScrollToKey("maze")
            pass(500)
            touches++
            tap(LearningTags.world("maze"), height)
            assertNotNull(workshop.state.learning.worldTask)
            program(workshop, "forward 20\n")
            makeAssignment(height)
            swipeTo(AssignmentTags.MAKE_TEXT, height)
            onNodeWithTag(AssignmentTags.MAKE_TEXT).performTextInput("Find the way out.")
            pass(300)
            touches++
            tap(AssignmentTags.MAKE_VARIATION_ADD, height)
            // A finger drags the robot.
            val robot = checkNotNull(workshop.state.worldEdit).world.robots.first()
            val turned = robot.copy(start = robot.start.copy(heading = robot.start.heading + 90))
            workshop.handle(
                WorldEditEvent.Edited(WorldEdit.Change(ElementRef(ElementKind.ROBOT, 0), Element.OfRobot(turned))),
            )
            touches++
            tap(WorldTags.EDIT_TO_ASSIGNMENT, height)
            tap(KitTags.close(AssignmentTags.ASSIGNMENT_MAKE), height)
            program(workshop, "forward 21\n")
            makeAssignment(height)
            tap(AssignmentTags.MAKE_CHECK, height)
            first = touches
            assertIs<SolutionCheck.Failed>(workshop.state.making?.check)
            tap(AssignmentTags.MAKE_TEACHER_FILE, height)
            tap(AssignmentTags.MAKE_PUPIL_FILE, height)
        }
        val saved = machine.files.disk.values.last()
        assertIs<ProjectFileResult.Success>(readProject(saved, Language.ENGLISH))
        return first to touches
    }

    @Test
    fun `the usual assignment takes few touches on a tablet and on a phone`() {
        for ((width, height) in listOf(1024 to 768, 360 to 740)) {
            val (check, all) = count(width, height)
            println("Touches on $width x $height: $check to the check, $all in all")
            assertTrue(all < MOST, "$all touches on $width x $height, $check of them to the check")
        }
    }

    private companion object {
        const val SWIPE = 0.75f
        const val MOST = 35
    }
}
