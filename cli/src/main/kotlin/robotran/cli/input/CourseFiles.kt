package robotran.cli.input

import kotlinx.coroutines.runBlocking
import robotran.cli.console.Console
import robotran.cli.console.messages
import robotran.cli.files.FileContent
import robotran.cli.files.LARGEST_FILE_BYTES
import robotran.cli.files.liesIn
import robotran.cli.files.readContent
import robotran.cli.files.reading
import robotran.documents.COURSE_EXTENSION
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.LinkResult
import robotran.projects.isCourseLink
import robotran.projects.openLink
import robotran.projects.readCourse
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory

/** Whether [name] is a course file, a folder with a course in it, or a link to a course. */
internal fun isCourse(name: String): Boolean =
    isCourseLink(name) || name.endsWith(COURSE_EXTENSION) || listIn(name)?.exists() == true

/** The course [name], of which [isCourse] holds. On error prints it and returns null. */
internal fun courseOf(name: String, console: Console): Course? {
    if (isCourseLink(name)) return linkedCourse(name, console)
    val folder = listIn(name)
    val content = reading(name, console.messages, FileContent::Rejected) {
        readContent(folder ?: Path(name), name, LARGEST_FILE_BYTES, console.messages)
    }
    return when (content) {
        is FileContent.Rejected -> {
            console.complain(content.reason)
            null
        }

        is FileContent.Read -> {
            val files = FilesBeside(folder ?: Path(name), console)
            when (val result = readCourse(content.bytes, console.language, files::read)) {
                is CourseFileResult.Loaded -> {
                    result.course
                }

                is CourseFileResult.Rejected -> {
                    console.complain("$name: ${files.problem ?: result.message}")
                    null
                }
            }
        }
    }
}

private fun linkedCourse(link: String, console: Console): Course? =
    when (val result = runBlocking { openLink(link, console.language) }) {
        is LinkResult.OfCourse -> {
            result.course
        }

        else -> {
            console.complain((result as? LinkResult.Rejected)?.message ?: link)
            null
        }
    }

/** The list of the course in the folder [name]; null if it is no folder. */
private fun listIn(name: String): Path? = try {
    Path(name).takeIf { it.isDirectory() }?.resolve(COURSE_EXTENSION)
} catch (_: InvalidPathException) {
    null
}

/** The files in the folder of [course]. The reader accepts only names without folders. */
private class FilesBeside(private val course: Path, private val console: Console) {
    /** Why a file that is there could not be read. */
    var problem: String? = null
        private set

    fun read(name: String): ByteArray? {
        val path = try {
            course.resolveSibling(name).takeIf { it.exists() } ?: return null
        } catch (_: InvalidPathException) {
            return null
        }
        val content = reading(name, console.messages, FileContent::Rejected) {
            val isInside = course.toAbsolutePath().parent?.let { liesIn(it, path) } ?: false
            if (isInside) {
                readContent(path, name, LARGEST_FILE_BYTES, console.messages)
            } else {
                FileContent.Rejected(console.messages.leadsOutside(name))
            }
        }
        if (content is FileContent.Rejected) problem = content.reason
        return (content as? FileContent.Read)?.bytes
    }
}
