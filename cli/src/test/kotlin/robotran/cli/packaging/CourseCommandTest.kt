package robotran.cli.packaging

import kotlinx.coroutines.runBlocking
import robotran.assignments.course.OwnCourses
import robotran.assignments.course.isForTeachers
import robotran.cli.CommandTest
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.LinkResult
import robotran.projects.openLink
import robotran.projects.readCourse
import robotran.projects.writeCourse
import robotran.projects.writeProject
import java.util.zip.ZipFile
import kotlin.io.path.readBytes
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull

class CourseCommandTest : CommandTest() {
    private val written get() = folder.resolve("out.course.json")
    private val drive = assertNotNull(OwnCourses.named("drive", Language.GERMAN, Language.GERMAN))

    private fun course(vararg arguments: String) =
        commandLine.execute(listOf("course", "-o", written.toString()) + arguments)

    private fun read(): Course =
        assertIs<CourseFileResult.Success>(readCourse(written.readBytes(), Language.ENGLISH)).course

    @Test
    fun `a strand is written as a course in the language that is asked for`() {
        assertEquals(0, course("drive", "--language", "de"), console.complaints.toString())
        assertEquals(drive, read())
    }

    @Test
    fun `the worlds are a course, too, and pupils get it without solutions`() {
        assertEquals(0, course("worlds", "--pupils"), console.complaints.toString())
        assertFalse(read().isForTeachers)
    }

    @Test
    fun `an unknown course is refused in a sentence that names the others`() {
        assertEquals(2, course("driving", "--language", "de"))
        assertContains(console.complaints.single(), "Es gibt keinen Kurs, der driving heißt")
        assertContains(console.complaints.single(), "drive")
    }

    private fun itemsOf(vararg given: String): List<String> {
        program("<p>the page</p>", "site/index.html")
        val output = folder.resolve("out.zip")
        val status = commandLine.execute(
            listOf("package", "--site", folder.resolve("site").toString(), "-o", output.toString()) + given,
        )
        assertEquals(0, status, console.complaints.toString())
        return ZipFile(output.toFile()).use { zip ->
            val manifest = zip.getInputStream(zip.getEntry("imsmanifest.xml")).readBytes().decodeToString()
            Regex("<title>(.*)</title>").findAll(manifest).map { it.groupValues[1] }.toList()
        }
    }

    @Test
    fun `a package holds the assignments of a course and has its title`() {
        val file = program(writeCourse(drive), "drive.course.json")
        assertEquals(listOf(drive.title) + drive.assignments.map { it.world.title }, itemsOf(file))
    }

    @Test
    fun `a folder with a course is a course`() {
        program(
            """{ "format": "robotran-course", "version": 1, "title": "C", "assignments": ["1.robotran"] }""",
            "c/course.json",
        )
        program(writeProject(drive.assignments[1]), "c/1.robotran")
        assertEquals(listOf("C", drive.assignments[1].world.title), itemsOf(folder.resolve("c").toString()))
    }

    @Test
    fun `a course whose file is missing says which one`() {
        program(
            """{ "format": "robotran-course", "version": 1, "title": "C", "assignments": ["1.robotran"] }""",
            "c/course.json",
        )
        assertEquals(2, commandLine.execute(listOf("link", folder.resolve("c").toString())))
        assertContains(console.complaints.single(), "needs the file \"1.robotran\"")
    }

    @Test
    fun `a course becomes a link, and a program cannot be run in it`() {
        val small = drive.copy(assignments = drive.assignments.take(2))
        assertEquals(0, commandLine.execute(listOf("link", program(writeCourse(small), "a.course.json"))))
        val link = console.said.single()
        assertEquals<LinkResult>(LinkResult.OfCourse(small), runBlocking { openLink(link, Language.ENGLISH) })
        assertEquals(2, commandLine.execute(listOf("run", link)))
        assertContains(console.complaints.single(), "is a whole course")
    }
}
