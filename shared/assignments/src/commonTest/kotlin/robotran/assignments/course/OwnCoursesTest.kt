package robotran.assignments.course

import robotran.assignments.ASSIGNMENT
import robotran.assignments.doing.firstPrograms
import robotran.language.Language
import robotran.learning.Lessons
import robotran.learning.hint.HintCondition
import robotran.projects.AssignmentTries
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.readCourse
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

class OwnCoursesTest {
    private val courses = Language.entries.flatMap { language ->
        OwnCourses.names.map { assertNotNull(OwnCourses.named(it, language)) }
    }

    @Test
    fun `each strand and the worlds are a course that can be written and read in every language`() {
        assertEquals(Lessons.strands.map { it.name } + "worlds", OwnCourses.names)
        for (course in courses) {
            val bytes = assertNotNull(courseFile(course), course.title)
            assertEquals(course, assertIs<CourseFileResult.Success>(readCourse(bytes, Language.ENGLISH)).course)
        }
    }

    @Test
    fun `every lesson is an assignment with the same id in all languages`() {
        val ids = courses.groupBy { it.id }.values
        for (same in ids) {
            assertEquals(
                1,
                same.map { course ->
                    course.assignments.map { it.assignmentId }
                }.toSet().size,
            )
        }
        assertEquals(
            Lessons.all.size,
            ids.sumOf { it.first().assignments.size } - OwnCourses.worlds(Language.ENGLISH).assignments.size,
        )
    }

    @Test
    fun `an assignment says what the lesson says`() {
        val maze = OwnCourses.worlds(Language.GERMAN).assignments.single { it.assignmentId == "robotran-world-maze" }
        assertEquals("Das Labyrinth", maze.world.title)
        val hints = assertNotNull(maze.assignment).hints
        assertTrue(hints.any { it.condition == "word missing: power right 1" })
        assertTrue(hints.mapNotNull { it.condition }.all { HintCondition.of(it) != null })
        assertEquals(listOf(1, 3, 5), hints.filter { it.condition == null }.map { it.afterTries })
        assertEquals(1..20, maze.assignment?.checks?.seeds)
        assertTrue(maze.world.task.isNotEmpty() && maze.firstPrograms.isNotEmpty())
        val repeat = assertNotNull(OwnCourses.named("drive", Language.ENGLISH)).assignments[2]
        assertTrue("\n\n" in repeat.assignment?.text.orEmpty())
    }

    @Test
    fun `programs, tasks and hints have the words that are asked for`() {
        val english = assertNotNull(OwnCourses.named("drive", Language.GERMAN)).assignments.first()
        val german = assertNotNull(OwnCourses.named("drive", Language.GERMAN, Language.GERMAN)).assignments.first()
        assertTrue("`forward 20`" in english.assignment?.text.orEmpty())
        assertTrue("`vorwärts 20`" in german.assignment?.text.orEmpty(), german.assignment?.text)
        assertTrue("vorwärts 20" in german.firstPrograms.first().program.files.first().text)
        assertTrue("drehe links 90" in assertNotNull(german.assignment).solution.first().program.files.first().text)
    }

    @Test
    fun `pupils get neither checks nor solutions`() {
        val course = OwnCourses.worlds(Language.ENGLISH)
        assertTrue(course.isForTeachers)
        val copy = pupilCopy(course)
        assertFalse(copy.isForTeachers)
        assertEquals(course.assignments.map { it.firstPrograms }, copy.assignments.map { it.firstPrograms })
        assertEquals(course, teacherCopy(course))
    }

    @Test
    fun `copies of a course have the same key, other courses another`() {
        val course = Course("A", assignments = listOf(ASSIGNMENT))
        assertEquals(course.key, pupilCopy(course).copy(title = "B").key)
        assertNotEquals(course.key, course.copy(id = "c").key)
        assertEquals(Course("A", id = "c").key, course.copy(id = "c").key)
        val tried = course.copy(assignments = listOf(ASSIGNMENT.copy(tries = AssignmentTries(3))))
        assertEquals(null, pupilCopy(tried).assignments.single().tries)
    }
}
