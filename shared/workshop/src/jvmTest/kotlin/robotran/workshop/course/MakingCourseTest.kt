package robotran.workshop.course

import kotlinx.coroutines.runBlocking
import robotran.assignments.course.OwnCourses
import robotran.assignments.course.isForTeachers
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.LinkResult
import robotran.projects.openLink
import robotran.projects.readCourse
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.assignment.AnyCourse
import robotran.workshop.documents.Machine
import robotran.workshop.documents.projectFile
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.CourseError
import robotran.workshop.state.CoursePage
import robotran.workshop.state.LinkError
import robotran.workshop.state.SavedOwnCourse
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class MakingCourseTest {
    private val machine = Machine()
    private val workshop = machine.window()
    private val Workshop.making: CoursePage.Making get() = assertIs(state.course.page)

    private fun choose(vararg numbers: Int) {
        machine.files.chosen =
            numbers.map { AnyAssignment.file(AnyCourse.teachers.assignments[it - 1], "$it.robotran") }
        workshop.handle(CourseEvent.FilesRequested)
    }

    private fun make() {
        workshop.handle(CourseEvent.MakingRequested(null))
        workshop.handle(CourseEvent.TitleChanged("Circles"))
        workshop.handle(CourseEvent.TextChanged("Three of them.\nIn order."))
        choose(1, 2, 3)
    }

    private fun saved(event: CourseEvent): Course {
        machine.files.location = "/home/out.course.json"
        workshop.handle(event)
        return assertIs<CourseFileResult.Success>(
            readCourse(machine.files.disk.getValue("/home/out.course.json"), Language.ENGLISH),
        ).course
    }

    private val ids get() = workshop.making.course.assignments.map { it.assignment?.id }

    @Test
    fun `a course is made of files, with title and text`() {
        workshop.handle(CourseEvent.MakingRequested(null))
        assertFalse(workshop.making.isComplete)
        make()
        assertTrue(workshop.making.isComplete && workshop.making.isKept)
        assertEquals(listOf<String?>("circle-1", "circle-2", "circle-3"), ids)
        assertTrue(workshop.making.course.id.isNotEmpty())
    }

    @Test
    fun `assignments are moved, removed and brought back`() {
        make()
        workshop.handle(CourseEvent.TaskMoved(2, -1))
        assertEquals(listOf<String?>("circle-1", "circle-3", "circle-2"), ids)
        workshop.handle(CourseEvent.TaskMoved(0, -1))
        workshop.handle(CourseEvent.TaskRemoved(0))
        assertEquals(listOf<String?>("circle-3", "circle-2"), ids)
        workshop.handle(CourseEvent.UndoRequested)
        workshop.handle(CourseEvent.UndoRequested)
        assertEquals(listOf<String?>("circle-1", "circle-2", "circle-3"), ids)
    }

    @Test
    fun `teachers and pupils get their copies as files`() {
        make()
        val teachers = saved(CourseEvent.TeacherFileSaved)
        assertTrue(teachers.isForTeachers)
        assertEquals("Circles (with solution).course.json", machine.files.suggestion)
        val pupils = saved(CourseEvent.PupilFileSaved)
        assertFalse(pupils.isForTeachers)
        assertEquals("Circles.course.json", machine.files.suggestion)
        assertEquals("out.course.json", workshop.making.savedAs)
        assertEquals(teachers.id, pupils.id)
        assertEquals("Three of them.\nIn order.", pupils.text)
    }

    @Test
    fun `a short course has a link without solutions, a long one has a sentence`() {
        make()
        workshop.handle(CourseEvent.LinkRequested)
        val link = assertNotNull(workshop.making.link?.link)
        val course = assertIs<LinkResult.OfCourse>(runBlocking { openLink(link, Language.ENGLISH) }).course
        assertFalse(course.isForTeachers)
        workshop.handle(CourseEvent.LinkCopied)
        assertTrue(workshop.making.link?.isCopied == true)
        workshop.handle(CourseEvent.LinkClosed)
        assertNull(workshop.making.link)
        machine.page = ""
        val offline = machine.window().apply {
            handle(CourseEvent.MakingRequested(null))
            handle(CourseEvent.LinkRequested)
        }
        assertEquals<LinkError?>(LinkError.NoSite, offline.making.link?.problem)
    }

    @Test
    fun `the device keeps the course, to be changed later`() {
        make()
        workshop.handle(CourseEvent.TitleChanged("More circles"))
        workshop.handle(CourseEvent.PageClosed)
        val page = assertIs<CoursePage.OneCourse>(workshop.state.course.page)
        assertEquals("More circles", page.title)
        assertTrue(page.canBeChanged)
        val other = machine.window()
        other.handle(CourseEvent.MakingRequested(page.key))
        assertEquals("More circles", other.making.course.title)
        other.handle(CourseEvent.TaskRemoved(0))
        assertEquals(2, other.making.course.assignments.size)
        other.handle(CourseEvent.PageClosed)
        assertEquals(2, assertIs<CoursePage.OneCourse>(other.state.course.page).tasks.size)
    }

    @Test
    fun `assignments come from My work, and an assignment that was changed takes its place`() {
        make()
        workshop.handle(CourseEvent.TaskOpened(1))
        assertNull(workshop.state.course.page)
        assertTrue(workshop.state.assignment?.isAuthor == true)
        assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
        workshop.handle(AssignmentEvent.MakingRequested)
        workshop.handle(AssignmentEvent.TaskChanged("The second circle", "Go."))
        workshop.handle(AssignmentEvent.MakingClosed)
        workshop.handle(CourseEvent.ListRequested)
        val list = assertIs<CoursePage.MyCourses>(workshop.state.course.page)
        workshop.handle(CourseEvent.MakingRequested(list.courses.single().key))
        workshop.handle(CourseEvent.WorksShown(true))
        val work = assertNotNull(workshop.making.works).single { it.title == "The second circle" }
        workshop.handle(CourseEvent.WorkAdded(work.id))
        assertNull(workshop.making.works)
        assertEquals(listOf<String?>("circle-1", "circle-2", "circle-3"), ids)
        assertEquals("The second circle", workshop.making.course.assignments[1].world.title)
    }

    @Test
    fun `what is no assignment is not added, and the page says so`() {
        make()
        machine.files.chosen = listOf(projectFile("beep\n"))
        workshop.handle(CourseEvent.FilesRequested)
        assertEquals<CourseError?>(CourseError.NotAnAssignment("maze"), workshop.making.problem)
        assertEquals(3, ids.size)
        machine.files.chosen = listOf(OpenedFile("x.robotran", "{".encodeToByteArray()))
        workshop.handle(CourseEvent.FilesRequested)
        assertIs<CourseError.NotOpened>(workshop.making.problem)
        choose(1)
        assertEquals(3, ids.size)
    }

    @Test
    fun `a whole course can be added, up to the limit`() {
        workshop.handle(CourseEvent.MakingRequested(null))
        val many = List(Course.MAXIMUM_ASSIGNMENTS) { AnyCourse.task(it, "T$it") }
        machine.files.chosen = listOf(AnyCourse.file(Course("Many", assignments = many)))
        workshop.handle(CourseEvent.FilesRequested)
        assertEquals(Course.MAXIMUM_ASSIGNMENTS, ids.size)
        machine.files.chosen = listOf(AnyAssignment.file(AnyCourse.task(100, "One more")))
        workshop.handle(CourseEvent.FilesRequested)
        assertEquals<CourseError?>(CourseError.TooMany(Course.MAXIMUM_ASSIGNMENTS), workshop.making.problem)
    }

    @Test
    fun `a strand of ours is saved as a file that the teacher can open and change`() {
        val course = saved(CourseEvent.OwnCourseSaved("drive"))
        assertEquals(OwnCourses.named("drive", Language.ENGLISH), course)
        assertEquals<SavedOwnCourse?>(SavedOwnCourse("drive", "out.course.json"), workshop.state.course.saved)
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(course))))
        val page = assertIs<CoursePage.OneCourse>(workshop.state.course.page)
        assertTrue(page.canBeChanged)
        workshop.handle(CourseEvent.MakingRequested(page.key))
        assertEquals(course, workshop.making.course)
    }
}
