package robotran.assignments.course

import robotran.assignments.ASSIGNMENT
import robotran.language.Language
import robotran.learning.Lessons
import robotran.projects.Project
import robotran.projects.writeProject
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class CourseFileTest {
    private val second = ASSIGNMENT.copy(
        world = ASSIGNMENT.world.copy(title = "Möbius & Co."),
        assignment = ASSIGNMENT.assignment?.copy(id = "draw-2"),
    )
    private val course = Course("Drawing", "One.\n\nTwo.", listOf(ASSIGNMENT, second))

    private fun load(text: String) = assertIs<CourseFileResult.Loaded>(readCourse(text)).course

    private fun refusal(text: String) = assertIs<CourseFileResult.Rejected>(readCourse(text)).message

    private fun files(course: Course) = courseFolder(course).associate { it.path to it.bytes }

    @Test
    fun `a course in one file or a folder is read as it was written`() {
        assertTrue(isCourse(writeCourse(course)))
        assertEquals(course, load(writeCourse(course)))
        val files = files(course)
        assertEquals(setOf("course.json", "01-draw.robotran", "02-möbius-co.robotran"), files.keys)
        assertEquals(course, assertIs<CourseFileResult.Loaded>(readCourseFolder(files)).course)
    }

    @Test
    fun `unknown fields stay`() {
        val text = writeCourse(course).replace("\"title\": \"Drawing\"", "\"title\": \"Drawing\", \"colour\": \"red\"")
        assertTrue("\"colour\": \"red\"" in writeCourse(load(text)))
    }

    @Test
    fun `what is wrong is told with its place`() {
        val text = writeCourse(course)
        assertTrue("is not a course" in refusal(writeProject(ASSIGNMENT)))
        assertTrue("newer Robotran" in refusal(text.replaceFirst("\"version\": 1", "\"version\": 2")))
        val twice = writeCourse(course.copy(assignments = listOf(ASSIGNMENT, ASSIGNMENT)))
        assertTrue("two assignments with the id \"draw-1\"" in refusal(twice), refusal(twice))
        val plain = writeCourse(course.copy(assignments = listOf(ASSIGNMENT, Project(ASSIGNMENT.world))))
        assertTrue("assignments[1]" in refusal(plain) && "must have \"assignment\"" in refusal(plain), refusal(plain))
    }

    @Test
    fun `what is wrong in a folder is told with its file`() {
        val files = files(course)
        val missing = assertIs<CourseFileResult.Rejected>(readCourseFolder(files - "01-draw.robotran"))
        assertEquals("The course names the file 01-draw.robotran, which is not there.", missing.message)
        val plain = files + ("01-draw.robotran" to writeProject(Project(ASSIGNMENT.world)).encodeToByteArray())
        assertEquals("01-draw.robotran", assertIs<CourseFileResult.Rejected>(readCourseFolder(plain)).file)
        assertIs<CourseFileResult.Rejected>(readCourseFolder(emptyMap()))
    }

    @Test
    fun `our own lessons and worlds are such courses, in all languages`() {
        for (language in Language.entries) {
            val courses = Lessons.strands.map { courseOf(it, language) } + courseOfWorlds(language)
            assertTrue(courses.all { it.assignments.isNotEmpty() })
            for (own in courses) {
                assertEquals(own, assertIs<CourseFileResult.Loaded>(readCourseFolder(files(own))).course, own.title)
            }
            courses.dropLast(1).forEach { assertEquals(it, load(writeCourse(it)), it.title) }
        }
        val first = courseOf(Lessons.strands.first(), Language.ENGLISH).assignments.first()
        val rules = checkNotNull(first.assignment)
        assertEquals(Lessons.all.first().name, rules.id)
        assertTrue(rules.hints.size >= 3 && rules.solution.size == 1 && first.robots.single().programs.size == 1)
    }
}
