package robotran.cli.input

import kotlinx.coroutines.runBlocking
import robotran.cli.console.Console
import robotran.cli.console.warn
import robotran.cli.files.FileContent
import robotran.cli.files.LARGEST_FILE_BYTES
import robotran.cli.files.isNamed
import robotran.cli.files.readContent
import robotran.cli.files.reading
import robotran.cli.messages.CommandMessages
import robotran.documents.COURSE_EXTENSION
import robotran.language.Language
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.LinkResult
import robotran.projects.isCourseLink
import robotran.projects.openLink
import robotran.projects.readCourse
import java.io.IOException
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.readBytes

/** Whether [name] is a course file, a folder with a course in it, or a link to a course. */
internal fun isCourse(name: String): Boolean =
    isCourseLink(name) || isNamed(name, COURSE_EXTENSION) || listIn(name)?.exists() == true

/** The result of reading a course file. */
internal sealed interface CourseReading {
    class Read(val result: CourseFileResult) : CourseReading

    /** [reason] is a sentence that names the file. */
    class Unreadable(val reason: String) : CourseReading
}

/** Reads the course file [name], or that in the folder [name], with the assignments beside it. */
internal fun readCourseFile(name: String, language: Language): CourseReading {
    val folder = listIn(name)
    val messages = CommandMessages.of(language)
    val content = reading(name, messages, FileContent::Rejected) {
        readContent(folder ?: Path(name), name, LARGEST_FILE_BYTES, messages)
    }
    return when (content) {
        is FileContent.Rejected -> {
            CourseReading.Unreadable(content.reason)
        }

        is FileContent.Read -> {
            CourseReading.Read(readCourse(content.bytes, language) { besides(folder ?: Path(name), it) })
        }
    }
}

/** The course [name], of which [isCourse] holds. On error prints it and returns null. */
internal fun courseOf(name: String, console: Console): Course? {
    if (isCourseLink(name)) return linkedCourse(name, console)
    return when (val reading = readCourseFile(name, console.language)) {
        is CourseReading.Unreadable -> {
            console.complain(reading.reason)
            null
        }

        is CourseReading.Read -> {
            when (val result = reading.result) {
                is CourseFileResult.Loaded -> {
                    console.warn(name, emptyList(), result.warnings)
                    result.course
                }

                is CourseFileResult.Rejected -> {
                    console.complain("$name: ${result.message}")
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

/** The reader accepts only names without folders. */
private fun besides(course: Path, name: String): ByteArray? = try {
    course.resolveSibling(name).takeIf { it.isRegularFile() }?.readBytes()
} catch (_: IOException) {
    null
} catch (_: InvalidPathException) {
    null
}
