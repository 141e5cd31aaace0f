package robotran.assignments.course

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.documents.IncomingFile
import robotran.documents.OpenFilesError
import robotran.documents.OpenFilesResult
import robotran.documents.ZipEntry
import robotran.documents.openFiles
import robotran.documents.openLinkText
import robotran.documents.zipOf
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.LinkCreation
import robotran.projects.linkOf
import robotran.projects.writeCourse
import robotran.projects.writeProject
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class OpenCourseTest {
    private val course = Course("A", "about", listOf(ASSIGNMENT), "a-1")
    private val list = """{ "format": "robotran-course", "version": 1, "id": "a-1", "title": "A", "text": ["about"],
        "assignments": ["draw.robotran"] }""".encodeToByteArray()
    private val assignment = writeProject(ASSIGNMENT).encodeToByteArray()

    private suspend fun opened(vararg files: IncomingFile) =
        assertIs<OpenFilesResult.Success>(openFiles(unpackedCourses(files.toList()), Language.ENGLISH))

    @Test
    fun `a course is opened as one file, also under a name that says nothing`() = runTest {
        val bytes = writeCourse(course).encodeToByteArray()
        assertEquals(listOf(course), opened(IncomingFile("a.course.json", bytes)).courses)
        assertEquals(listOf(course), opened(IncomingFile("download", bytes)).courses)
    }

    @Test
    fun `the files of a folder together are a course, and no projects of their own`() = runTest {
        val result = opened(IncomingFile("draw.robotran", assignment), IncomingFile("course.json", list))
        assertEquals(listOf(course), result.courses)
        assertEquals(emptyList(), result.projects)
    }

    @Test
    fun `a course without its files says which one it needs`() = runTest {
        val result = openFiles(listOf(IncomingFile("course.json", list)), Language.ENGLISH)
        val error = assertIs<OpenFilesError.InFile>(assertIs<OpenFilesResult.Failure>(result).error)
        assertEquals(true, "draw.robotran" in error.message)
    }

    @Test
    fun `a zip of the folder is a course, also with the folder in it`() = runTest {
        for (folder in listOf("", "first/")) {
            val zip = zipOf(
                listOf(
                    ZipEntry("${folder}draw.robotran", assignment),
                    ZipEntry("${folder}course.json", list),
                    ZipEntry("${folder}notes.txt", ByteArray(3)),
                ),
            )
            assertEquals(listOf(course), opened(IncomingFile("first.zip", zip)).courses)
        }
    }

    @Test
    fun `other zips stay what they are`() = runTest {
        val zip = zipOf(listOf(ZipEntry("a.robo", ByteArray(3))))
        for (bytes in listOf(zip, ByteArray(10))) {
            val result = openFiles(unpackedCourses(listOf(IncomingFile("a.zip", bytes))), Language.ENGLISH)
            assertIs<OpenFilesResult.Failure>(result)
        }
    }

    @Test
    fun `a link opens a course`() = runTest {
        val link = assertIs<LinkCreation.Made>(linkOf(course, Language.ENGLISH)).fragment
        assertEquals(
            listOf(course),
            assertIs<OpenFilesResult.Success>(openLinkText("https://a.b/$link", Language.ENGLISH)).courses,
        )
    }
}
