package robotran.ui.course

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performScrollToKey
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.requestFocus
import robotran.assignments.course.pupilCopy
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.assignment.AnyCourse
import robotran.workshop.documents.Machine
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.LearningPage
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull

@OptIn(ExperimentalTestApi::class)
class CoursePagesTest {
    private val machine = Machine()

    private fun onCourse(width: Int = 411, height: Int = 891, check: ComposeUiTest.(Workshop) -> Unit) {
        val workshop = machine.window(AnyCourse.request(pupilCopy(AnyCourse.teachers)))
        onScreenOf(workshop, width, height) { check(workshop) }
    }

    private fun ComposeUiTest.touch(tag: String) {
        onNodeWithTag(tag).performClick()
        pass(600)
    }

    private fun ComposeUiTest.assertStop(index: Int, condition: String) {
        onNodeWithTag("course-task-$index").assert(
            SemanticsMatcher.expectValue(SemanticsProperties.StateDescription, condition),
        )
    }

    private fun Workshop.attempt(text: String) {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(20_000)
    }

    @Test
    fun `a pupil begins, solves, goes on from the outcome and comes back`() = onCourse { workshop ->
        onNodeWithTag("course-done").assertTextContains("0 of 3", substring = true)
        onNodeWithTag("course-go-on").assertTextContains("Begin: Into the circle")
        assertStop(0, "next")
        touch("course-go-on")
        onNodeWithTag("course-page").assertDoesNotExist()
        workshop.attempt(AnyAssignment.SOLUTION)
        pass(600)
        onNodeWithTag("solved-course-next").assertIsDisplayed().assertTextContains("Next: Out of the circle")
        touch("solved-course-next")
        assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
        workshop.attempt("pen down\nforward 6\n")
        workshop.handle(CourseEvent.OpenCourseRequested)
        pass(600)
        assertStop(0, "done")
        assertStop(1, "next, 1 of 2 goals")
        assertStop(2, "not done yet")
        onNodeWithTag("course-go-on").assertTextContains("Go on: Out of the circle")
    }

    @Test
    fun `after the last one the outcome leads back to the course`() = onCourse(1280, 800) { workshop ->
        for (index in 0..2) {
            workshop.handle(CourseEvent.OpenCourseRequested)
            pass(200)
            touch("course-task-$index")
            workshop.attempt(AnyAssignment.SOLUTION)
            pass(300)
        }
        onNodeWithTag("solved-course-next").assertDoesNotExist()
        touch("solved-course")
        onNodeWithTag("course-all-done").assertIsDisplayed()
    }

    @Test
    fun `the menu lists the courses, and one is removed after a question`() = onCourse { workshop ->
        touch("course-page-close")
        touch("menu")
        touch("menu-courses")
        val key = assertIs<CoursePage.MyCourses>(workshop.state.course.page).courses.single().key
        touch("course-remove-$key")
        touch("course-remove-no")
        onNodeWithTag("course-$key").assertIsDisplayed()
        touch("course-remove-$key")
        touch("course-remove-yes")
        onNodeWithTag("courses-none").assertIsDisplayed()
        touch("courses-page-close")
        assertNull(workshop.state.course.page)
    }

    @Test
    fun `a teacher makes a course with the keyboard and buttons`() = onCourse(1280, 1400) { workshop ->
        workshop.handle(CourseEvent.ListRequested)
        pass(300)
        touch("courses-make")
        onNodeWithTag("course-incomplete").assertIsDisplayed()
        onNodeWithTag("course-title").performTextInput("Circles")
        onNodeWithTag("course-text").performTextInput("In order.")
        machine.files.chosen =
            AnyCourse.teachers.assignments.mapIndexed { index, it -> AnyAssignment.file(it, "$index.robotran") }
        touch("course-add-files")
        onNodeWithTag("course-up-0").assertIsNotEnabled()
        touch("course-down-0")
        val course = assertIs<CoursePage.Making>(workshop.state.course.page).course
        assertEquals(listOf<String?>("circle-2", "circle-1", "circle-3"), course.assignments.map { it.assignment?.id })
        assertEquals("Circles" to "In order.", course.title to course.text)
        touch("course-take-out-2")
        touch("course-undo")
        onNodeWithTag("course-row-2").assertExists()
        machine.files.location = "/home/a.course.json"
        touch("course-pupil-file")
        onNodeWithTag("course-saved").assertTextContains("a.course.json", substring = true)
        touch("course-link")
        onNodeWithTag("course-qr").assertExists()
    }

    @Test
    fun `a teacher moves, renames and removes with keys alone`() = onCourse(1280, 1400) { workshop ->
        workshop.handle(CourseEvent.MakingRequested(null))
        machine.files.chosen =
            AnyCourse.teachers.assignments.mapIndexed { index, it -> AnyAssignment.file(it, "$index.robotran") }
        pass(300)
        press("course-add-files")
        val making = { assertIs<CoursePage.Making>(workshop.state.course.page).course }
        press("course-down-0")
        press("course-down-1")
        press("course-up-1")
        val order = { making().assignments.map { it.assignment?.id?.substringAfter('-') } }
        assertEquals(listOf<String?>("3", "2", "1"), order())
        press("course-take-out-1")
        assertEquals(listOf<String?>("3", "1"), order())
        press("course-undo")
        assertEquals(3, order().size)
        onNodeWithTag("course-title").performTextInput("Circles")
        onNodeWithTag("course-title").performTextReplacement("Rings")
        pass(300)
        assertEquals("Rings", making().title)
        onNodeWithTag("course-title").performKeyInput { pressKey(Key.Escape) }
        pass(600)
        assertEquals("Rings", assertIs<CoursePage.OneCourse>(workshop.state.course.page).title)
    }

    private fun ComposeUiTest.press(tag: String) {
        onNodeWithTag(tag).requestFocus()
        pass(100)
        onNodeWithTag(tag).performKeyInput { pressKey(Key.Enter) }
        pass(600)
    }

    @Test
    fun `the card of the task says where the pupil is in the course and leads on and back`() {
        for ((width, height) in listOf(411 to 891, 1280 to 800)) {
            onCourse(width, height) { workshop ->
                touch("course-go-on")
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(300)
                onNodeWithTag("course-place").assertTextContains("Circles: assignment 1 of 3")
                scrollAndTouch("course-line-next")
                pass(600)
                assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(300)
                scrollAndTouch("course-line-back")
                pass(600)
                assertIs<CoursePage.OneCourse>(workshop.state.course.page)
            }
        }
    }

    @Test
    fun `a strand and the worlds are saved as courses from their pages`() = onCourse(1280, 1400) { workshop ->
        workshop.handle(CourseEvent.PageClosed)
        machine.files.location = "/home/drive.course.json"
        workshop.handle(LearningEvent.PageRequested(LearningPage.MAP))
        pass(300)
        touch("course-save-drive")
        onNodeWithTag("course-saved-drive").assertTextContains("drive.course.json", substring = true)
        workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
        pass(300)
        onNodeWithTag("world-cards").assertIsDisplayed()
        onNodeWithTag("world-cards").performScrollToKey("save")
        pass(300)
        touch("course-save-worlds")
        assertEquals("worlds", assertNotNull(workshop.state.course.saved).name)
    }
}
