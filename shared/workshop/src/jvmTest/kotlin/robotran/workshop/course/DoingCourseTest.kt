package robotran.workshop.course

import kotlinx.coroutines.runBlocking
import robotran.assignments.course.pupilCopy
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.projects.writeProject
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.assignment.AnyCourse
import robotran.workshop.documents.Machine
import robotran.workshop.documents.keep
import robotran.workshop.documents.projectFile
import robotran.workshop.documents.projects
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.CoursePage
import robotran.workshop.state.Notice
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class DoingCourseTest {
    private val machine = Machine()
    private val pupils = pupilCopy(AnyCourse.teachers)

    private fun window(course: Course = pupils): Workshop = machine.window(AnyCourse.request(course))

    private val Workshop.shown: CoursePage.OneCourse get() = assertIs(state.course.page)
    private val Workshop.list: CoursePage.MyCourses get() = assertIs(state.course.page)

    private fun Workshop.attempt(text: String) {
        handle(ProgramEvent.ProgramEdited(text))
        handle(RunEvent.RunPressed)
        advance(20_000)
    }

    private fun Workshop.restart(): Workshop {
        runBlocking { assertTrue(closeDocument()) }
        close()
        return machine.window()
    }

    @Test
    fun `a course opens on its page with nothing begun`() {
        val page = window().shown
        assertEquals("Circles", page.title)
        assertEquals(listOf("Into the circle", "Out of the circle", "Around the circle"), page.tasks.map { it.title })
        assertTrue(page.tasks.none { it.isBegun || it.isDone })
        assertEquals(0, page.next)
        assertFalse(page.canBeChanged)
    }

    @Test
    fun `opening a course leaves the open project alone`() {
        val workshop = machine.window()
        workshop.handle(ProgramEvent.ProgramEdited("beep\n"))
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(pupils))))
        assertEquals("beep\n", workshop.state.programText)
        workshop.handle(CourseEvent.PageClosed)
        assertNull(workshop.state.course.page)
    }

    @Test
    fun `choosing an assignment begins it as a project of its own`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(1))
        assertNull(workshop.state.course.page)
        assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
        assertEquals("Out of the circle", workshop.state.document.name)
        val open = assertNotNull(workshop.state.course.open)
        assertEquals(2 to 3, open.number to open.count)
        assertEquals("Around the circle", open.next)
    }

    @Test
    fun `work is found again, with the program that the pupil wrote`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.attempt("forward 5\n")
        workshop.handle(CourseEvent.OpenCourseRequested)
        assertTrue(workshop.shown.tasks[0].isBegun && !workshop.shown.tasks[0].isDone)
        workshop.handle(CourseEvent.TaskChosen(1))
        workshop.handle(CourseEvent.OpenCourseRequested)
        workshop.handle(CourseEvent.TaskChosen(0))
        assertEquals("forward 5\n", workshop.state.programText)
        assertEquals(2, workshop.projects().size)
        val again = workshop.restart()
        again.handle(CourseEvent.ListRequested)
        again.handle(CourseEvent.CourseChosen(again.list.courses.single().key))
        again.handle(CourseEvent.TaskChosen(0))
        assertEquals("forward 5\n", again.state.programText)
        assertEquals(2, again.projects().size)
    }

    @Test
    fun `choosing the assignment that is open goes on with it`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.handle(ProgramEvent.ProgramEdited("forward 7\n"))
        workshop.handle(CourseEvent.OpenCourseRequested)
        workshop.handle(CourseEvent.TaskChosen(0))
        assertEquals("forward 7\n", workshop.state.programText)
        assertEquals(1, workshop.projects().size)
    }

    @Test
    fun `a solved assignment is done, and the next one goes on`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.handle(CourseEvent.NextTaskChosen)
        assertEquals("circle-2", workshop.state.assignment?.assignment?.id)
        workshop.handle(CourseEvent.OpenCourseRequested)
        val page = workshop.shown
        assertEquals(listOf(true, false, false), page.tasks.map { it.isDone })
        assertNotNull(page.tasks[0].best)
        assertEquals(1, page.next)
        assertEquals(1, page.done)
    }

    @Test
    fun `after the last assignment the first one that is not done comes`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(2))
        workshop.attempt(AnyAssignment.SOLUTION)
        assertEquals("Into the circle", workshop.state.course.open?.next)
        for (number in 1..2) {
            workshop.handle(CourseEvent.NextTaskChosen)
            assertEquals("circle-$number", workshop.state.assignment?.assignment?.id)
            workshop.attempt(AnyAssignment.SOLUTION)
        }
        assertNull(workshop.state.course.open?.next)
        workshop.handle(CourseEvent.NextTaskChosen)
        assertNull(workshop.shown.next)
        assertEquals(3, workshop.shown.done)
    }

    @Test
    fun `what was done stays done when the pupil deletes the work`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.keep()
        workshop.handle(CourseEvent.TaskChosen(1))
        workshop.handle(CourseEvent.OpenCourseRequested)
        workshop.handle(CourseEvent.TaskChosen(1))
        val first = workshop.projects().first { !it.isOpen }.entry.id
        workshop.handle(DocumentEvent.ProjectListRequested)
        workshop.handle(DocumentEvent.ProjectDeleted(first))
        workshop.handle(DocumentEvent.DialogClosed)
        workshop.handle(CourseEvent.OpenCourseRequested)
        assertTrue(workshop.shown.tasks[0].isDone)
        workshop.handle(CourseEvent.TaskChosen(0))
        assertEquals(AnyAssignment.BEGIN, workshop.state.programText)
    }

    @Test
    fun `a newer copy of a course takes the place of the older one and keeps what was done`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.attempt(AnyAssignment.SOLUTION)
        val more = pupils.copy(
            title = "More circles",
            assignments =
                pupils.assignments.reversed().take(2) + pupils.assignments.first(),
        )
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(more))))
        assertEquals(listOf(false, false, true), workshop.shown.tasks.map { it.isDone })
        workshop.handle(CourseEvent.ListRequested)
        assertEquals(listOf("More circles"), workshop.list.courses.map { it.title })
        assertEquals(1, workshop.list.courses.single().done)
    }

    @Test
    fun `another course takes nobody's place`() {
        val workshop = window()
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(pupils.copy(id = "other", title = "Other")))))
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(AnyCourse.teachers))))
        workshop.handle(CourseEvent.ListRequested)
        assertEquals(3, workshop.list.courses.size)
        assertEquals(1, workshop.list.courses.count { it.isForTeachers })
    }

    @Test
    fun `a course is removed only after a question, and the work stays`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.attempt(AnyAssignment.SOLUTION)
        workshop.handle(CourseEvent.ListRequested)
        val key = workshop.list.courses.single().key
        workshop.handle(CourseEvent.RemovalRequested(key))
        workshop.handle(CourseEvent.PageClosed)
        assertEquals(1, workshop.list.courses.size)
        workshop.handle(CourseEvent.RemovalRequested(key))
        workshop.handle(CourseEvent.Removed)
        assertEquals(emptyList(), workshop.list.courses)
        assertNull(workshop.state.course.open)
        assertEquals(1, workshop.projects().size)
        assertTrue(machine.window().apply { handle(CourseEvent.ListRequested) }.list.courses.isEmpty())
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(pupils))))
        assertTrue(workshop.shown.tasks[0].isDone, "work at a course that comes back is found again")
    }

    @Test
    fun `a link and the files of a folder open a course, too`() {
        val link = runBlocking { assertIs<LinkCreation.Made>(linkOf(pupils, Language.ENGLISH)).fragment }
        assertEquals("Circles", machine.window(OpenRequest.OfLink("https://school.example/$link")).shown.title)
        val list = """{ "format": "robotran-course", "version": 1, "title": "Folder", "assignments": ["1.robotran"] }"""
        val files = listOf(
            OpenedFile("1.robotran", writeProject(pupils.assignments[0]).encodeToByteArray()),
            OpenedFile("course.json", list.encodeToByteArray()),
        )
        val folder = machine.window(OpenRequest.OfFiles(files))
        assertEquals("Folder", folder.shown.title)
        assertNull(folder.state.assignment)
    }

    @Test
    fun `courses that do not fit on the device are refused and those that are there stay`() {
        val workshop = window()
        machine.store.full = true
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(pupils.copy(id = "other")))))
        assertIs<Notice.FileNotSaved>(workshop.state.notice)
        machine.store.full = false
        repeat(CourseRepository.MAXIMUM_COURSES) {
            workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(pupils.copy(id = "c$it")))))
        }
        assertEquals<Notice?>(Notice.TooManyCourses(CourseRepository.MAXIMUM_COURSES), workshop.state.notice)
        workshop.handle(CourseEvent.ListRequested)
        assertEquals(CourseRepository.MAXIMUM_COURSES, workshop.list.courses.size)
    }

    @Test
    fun `a damaged record does not hide its course`() {
        window().restart()
        val name = runBlocking { machine.store.names().single { it.endsWith(".progress") } }
        runBlocking { machine.store.write(name, "{") }
        assertEquals(
            listOf("Circles"),
            machine.window().apply {
                handle(CourseEvent.ListRequested)
            }.list.courses.map { it.title },
        )
    }

    @Test
    fun `another project belongs to no course`() {
        val workshop = window()
        workshop.handle(CourseEvent.TaskChosen(0))
        workshop.handle(LearningEvent.WorldChosen("maze"))
        assertNull(workshop.state.course.open)
    }

    @Test
    fun `a project that is opened is not hidden by a page`() {
        val workshop = window()
        workshop.handle(DocumentEvent.FilesBrought(listOf(projectFile("beep\n"))))
        assertNull(workshop.state.course.page)
        assertEquals("beep\n", workshop.state.programText)
        workshop.handle(CourseEvent.MakingRequested(null))
        workshop.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(pupils))))
        assertEquals("Circles", workshop.shown.title)
    }
}
