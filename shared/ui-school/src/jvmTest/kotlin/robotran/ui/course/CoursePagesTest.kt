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
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.tags.CourseTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.screen.onScreenOf
import robotran.ui.screen.pass
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.ui.screen.tags.ScreenTags
import robotran.uikit.KitTags
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
        onNodeWithTag(CourseTags.task(index)).assert(
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
        onNodeWithTag(CourseTags.COURSE_DONE).assertTextContains("0 of 3", substring = true)
        onNodeWithTag(CourseTags.COURSE_GO_ON).assertTextContains("Begin: Into the circle")
        assertStop(0, "next")
        touch(CourseTags.COURSE_GO_ON)
        onNodeWithTag(CourseTags.COURSE_PAGE).assertDoesNotExist()
        workshop.attempt(AnyAssignment.SOLUTION)
        pass(600)
        scrollTo(CourseTags.SOLVED_COURSE_NEXT)
        onNodeWithTag(CourseTags.SOLVED_COURSE_NEXT).assertIsDisplayed().assertTextContains("Next: Out of the circle")
        touch(CourseTags.SOLVED_COURSE_NEXT)
        assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
        workshop.attempt("pen down\nforward 6\n")
        workshop.handle(CourseEvent.OpenCourseRequested)
        pass(600)
        assertStop(0, "done")
        assertStop(1, "next, 1 of 2 goals")
        assertStop(2, "not done yet")
        onNodeWithTag(CourseTags.COURSE_GO_ON).assertTextContains("Go on: Out of the circle")
    }

    @Test
    fun `after the last one the outcome leads back to the course`() = onCourse(1280, 800) { workshop ->
        for (index in 0..2) {
            workshop.handle(CourseEvent.OpenCourseRequested)
            pass(200)
            touch(CourseTags.task(index))
            workshop.attempt(AnyAssignment.SOLUTION)
            pass(300)
        }
        onNodeWithTag(CourseTags.SOLVED_COURSE_NEXT).assertDoesNotExist()
        touch(CourseTags.SOLVED_COURSE)
        onNodeWithTag(CourseTags.COURSE_ALL_DONE).assertIsDisplayed()
    }

    @Test
    fun `below the lessons are the courses, and one is removed after a question`() = onCourse { workshop ->
        touch(KitTags.close(CourseTags.COURSE_PAGE))
        touch(ScreenTags.MENU)
        touch(ScreenTags.MENU_MAP)
        onNodeWithTag(LearningTags.MAP).performScrollToKey("courses")
        pass(300)
        touch(LearningTags.MAP_COURSES)
        val key = assertIs<CoursePage.MyCourses>(workshop.state.course.page).courses.single().key
        touch(CourseTags.remove(key))
        touch(CourseTags.COURSE_REMOVE_NO)
        onNodeWithTag(CourseTags.course(key)).assertIsDisplayed()
        touch(CourseTags.remove(key))
        touch(CourseTags.COURSE_REMOVE_YES)
        onNodeWithTag(CourseTags.COURSES_NONE).assertIsDisplayed()
        touch(KitTags.close(CourseTags.COURSES_PAGE))
        assertNull(workshop.state.course.page)
    }

    @Test
    fun `a teacher makes a course with the keyboard and buttons`() = onCourse(1280, 1400) { workshop ->
        workshop.handle(CourseEvent.ListRequested)
        pass(300)
        touch(CourseTags.COURSES_MAKE)
        onNodeWithTag(CourseTags.COURSE_INCOMPLETE).assertIsDisplayed()
        onNodeWithTag(CourseTags.COURSE_TITLE).performTextInput("Circles")
        onNodeWithTag(CourseTags.COURSE_TEXT).performTextInput("In order.")
        machine.files.chosen =
            AnyCourse.teachers.assignments.mapIndexed { index, it -> AnyAssignment.file(it, "$index.robotran") }
        touch(CourseTags.COURSE_ADD_FILES)
        onNodeWithTag(CourseTags.up(0)).assertIsNotEnabled()
        touch(CourseTags.down(0))
        val course = assertIs<CoursePage.Making>(workshop.state.course.page).course
        assertEquals(listOf<String?>("circle-2", "circle-1", "circle-3"), course.assignments.map { it.assignment?.id })
        assertEquals("Circles" to "In order.", course.title to course.text)
        touch(CourseTags.takeOut(2))
        touch(CourseTags.COURSE_UNDO)
        onNodeWithTag(CourseTags.row(2)).assertExists()
        machine.files.location = "/home/a.course.json"
        touch(CourseTags.COURSE_PUPIL_FILE)
        onNodeWithTag(CourseTags.COURSE_SAVED).assertTextContains("a.course.json", substring = true)
        touch(CourseTags.COURSE_LINK)
        onNodeWithTag(AssignmentTags.qr(CourseTags.COURSE)).assertExists()
    }

    @Test
    fun `a teacher moves, renames and removes with keys alone`() = onCourse(1280, 1400) { workshop ->
        workshop.handle(CourseEvent.MakingRequested(null))
        machine.files.chosen =
            AnyCourse.teachers.assignments.mapIndexed { index, it -> AnyAssignment.file(it, "$index.robotran") }
        pass(300)
        press(CourseTags.COURSE_ADD_FILES)
        val making = { assertIs<CoursePage.Making>(workshop.state.course.page).course }
        press(CourseTags.down(0))
        press(CourseTags.down(1))
        press(CourseTags.up(1))
        val order = { making().assignments.map { it.assignment?.id?.substringAfter('-') } }
        assertEquals(listOf<String?>("3", "2", "1"), order())
        press(CourseTags.takeOut(1))
        assertEquals(listOf<String?>("3", "1"), order())
        press(CourseTags.COURSE_UNDO)
        assertEquals(3, order().size)
        onNodeWithTag(CourseTags.COURSE_TITLE).performTextInput("Circles")
        onNodeWithTag(CourseTags.COURSE_TITLE).performTextReplacement("Rings")
        pass(300)
        assertEquals("Rings", making().title)
        onNodeWithTag(CourseTags.COURSE_TITLE).performKeyInput { pressKey(Key.Escape) }
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
                touch(CourseTags.COURSE_GO_ON)
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(300)
                onNodeWithTag(CourseTags.COURSE_PLACE).assertTextContains("Circles: assignment 1 of 3")
                scrollAndTouch(CourseTags.COURSE_LINE_NEXT)
                pass(600)
                assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
                workshop.handle(ScreenEvent.TaskShown(true))
                pass(300)
                scrollAndTouch(CourseTags.COURSE_LINE_BACK)
                pass(600)
                assertIs<CoursePage.OneCourse>(workshop.state.course.page)
            }
        }
    }

    @Test
    fun `a teacher saves a strand and the worlds as courses`() = onCourse(1280, 1400) { workshop ->
        workshop.handle(CourseEvent.PageClosed)
        machine.files.location = "/home/drive.course.json"
        workshop.handle(LearningEvent.PageRequested(LearningPage.TEACHERS))
        pass(300)
        touch(LearningTags.courseSave("drive"))
        onNodeWithTag(LearningTags.courseSaved("drive")).assertTextContains("drive.course.json", substring = true)
        touch(LearningTags.courseSave("worlds"))
        assertEquals("worlds", assertNotNull(workshop.state.course.saved).name)
    }
}
