package robotran.projects

import kotlinx.coroutines.test.runTest
import kotlinx.serialization.json.JsonPrimitive
import robotran.language.Language
import robotran.world.UnknownFields
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class CourseFileTest {
    private val random = Random(2005)

    private fun assignment(number: Int, unknown: UnknownFields = UnknownFields.NONE) = EVERY_ASSIGNMENT.copy(
        assignment = EVERY_ASSIGNMENT.assignment?.copy(id = "draw-$number"),
        unknown = unknown,
    )

    private fun course() = Course(
        title = words(1),
        text = List(random.nextInt(4)) { words(0) }.joinToString("\n"),
        assignments = List(random.nextInt(1, 6)) { assignment(it, unknown()) },
        id = if (random.nextBoolean()) "" else words(1).take(AssignmentLimits.MAXIMUM_ID_CHARACTERS),
        unknown = unknown(),
    )

    private fun words(least: Int) = List(random.nextInt(least, 8)) { listOf("a", "é", "\"", "\\", "語").random(random) }
        .joinToString("")

    private fun unknown() =
        if (random.nextBoolean()) UnknownFields.NONE else UnknownFields(mapOf("_new" to JsonPrimitive(words(0))))

    private fun course(text: String, beside: (String) -> ByteArray? = { null }): Course =
        when (val result = readCourse(text, beside = beside, language = Language.ENGLISH)) {
            is CourseFileResult.Success -> result.course
            is CourseFileResult.Failure -> throw AssertionError(result.message)
        }

    private fun refusal(text: String, language: Language = Language.ENGLISH): String =
        assertIs<CourseFileResult.Failure>(readCourse(text, language)).message

    private val plain = Course("First steps", assignments = listOf(assignment(1), assignment(2)))

    private fun listOfFiles(names: List<String>) = """{ "format": "robotran-course", "version": 1, "title": "A",
        "assignments": [${names.joinToString { "\"$it\"" }}] }"""

    @Test
    fun `any course is read as it was written`() {
        repeat(100) { course().let { assertEquals(it, course(writeCourse(it))) } }
    }

    @Test
    fun `any course survives a link`() = runTest {
        repeat(30) {
            val course = course()
            val link = assertIs<LinkCreation.Made>(linkOf(course, Language.ENGLISH)).fragment
            assertTrue(link.startsWith("#c=a"), link)
            assertEquals<LinkResult>(LinkResult.OfCourse(course), openLink(link, Language.ENGLISH))
        }
    }

    @Test
    fun `a damaged course gives a result`() {
        val text = writeCourse(plain)
        repeat(1000) {
            val from = random.nextInt(text.length)
            val with = listOf("", "\"", "{", "}", "[", ",", "1", "null", "\\", "\n", "é").random(random)
            when (
                val result = readCourse(
                    text.replaceRange(from, minOf(text.length, from + random.nextInt(9)), with),
                    language = Language.ENGLISH,
                )
            ) {
                is CourseFileResult.Success -> assertEquals(result.course, course(writeCourse(result.course)))
                is CourseFileResult.Failure -> assertTrue(result.message.endsWith("."), result.message)
            }
        }
    }

    @Test
    fun `a course in a folder names the files of its assignments`() {
        val text = listOf("1.robotran", "2.robotran").let(::listOfFiles)
        val files = (1..2).associate { "$it.robotran" to writeProject(assignment(it)).encodeToByteArray() }
        assertEquals(listOf(assignment(1), assignment(2)), course(text, files::get).assignments)
        assertEquals(files.keys.toList(), assignmentFilesOf(text))
        assertTrue("needs the file \"1.robotran\"" in refusal(text))
        assertTrue("braucht die Datei \"1.robotran\"" in refusal(text, Language.GERMAN))
        val broken = readCourse(text, beside = { "{".encodeToByteArray() }, language = Language.ENGLISH)
        assertTrue("1.robotran: " in assertIs<CourseFileResult.Failure>(broken).message)
    }

    @Test
    fun `what cannot be a course says why`() {
        val text = writeCourse(plain)
        assertTrue("not a Robotran course" in refusal(writeProject(EVERY_ASSIGNMENT)))
        assertTrue("newer Robotran" in refusal(text.replaceFirst("\"version\": 1", "\"version\": 2")))
        assertTrue("has the id \"draw-1\"" in refusal(text.replaceFirst("draw-2", "draw-1")))
        val plainProject = plain.copy(assignments = listOf(EVERY_ASSIGNMENT.copy(assignment = null)))
        assertTrue("must be an assignment" in refusal(writeCourse(plainProject)))
        assertTrue("must be an assignment" in refusal(writeCourse(plain.copy(assignments = listOf(EVERY_HAND_IN)))))
        assertTrue("assignments" in refusal(writeCourse(plain.copy(assignments = emptyList()))))
        val escaping = listOfFiles(listOf("../1.robotran"))
        assertTrue("without a folder" in refusal(escaping))
    }

    @Test
    fun `the documented courses are read, and written with the same content`() {
        assertTrue(documentedCourses.isNotEmpty())
        for (text in documentedCourses.values) {
            val names = assignmentFilesOf(text)
            val files = names.withIndex().associate { (number, name) -> name to writeProject(assignment(number)) }
            val course = course(text) { files[it]?.encodeToByteArray() }
            assertTrue(course.title.isNotEmpty() && course.text.isNotEmpty())
            assertEquals(course, course(writeCourse(course)))
        }
    }
}
