package robotran.cli.input

import kotlinx.coroutines.runBlocking
import robotran.cli.console.warn
import robotran.cli.files.FileContent
import robotran.cli.files.LARGEST_FILE_BYTES
import robotran.cli.files.isNamed
import robotran.cli.files.liesIn
import robotran.cli.files.readContent
import robotran.cli.files.reading
import robotran.cli.messages.CommandMessages
import robotran.console.Console
import robotran.documents.COURSE_EXTENSION
import robotran.language.Language
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
    isCourseLink(name) || isNamed(name, COURSE_EXTENSION) || listIn(name)?.exists() == true

/** The result of reading a course file. */
internal sealed interface CourseReading {
    class Success(val result: CourseFileResult) : CourseReading

    /** [reason] is a sentence that names the file. */
    class Failure(val reason: String) : CourseReading
}

/** Reads the course file [name], or that in the folder [name], with the assignments beside it. */
internal fun readCourseFile(name: String, language: Language): CourseReading {
    val folder = listIn(name)
    val messages = CommandMessages.of(language)
    val content = reading(name, messages, FileContent::Failure) {
        readContent(folder ?: Path(name), name, LARGEST_FILE_BYTES, messages)
    }
    return when (content) {
        is FileContent.Failure -> CourseReading.Failure(content.reason)

        is FileContent.Success -> {
            val files = FilesBeside(folder ?: Path(name), messages)
            val result = readCourse(content.bytes, language, files::read)
            val problem = files.problem.takeIf { result is CourseFileResult.Failure }
            if (problem == null) CourseReading.Success(result) else CourseReading.Failure("$name: $problem")
        }
    }
}

/** The course [name], of which [isCourse] holds. On error prints it and returns null. */
internal fun courseOf(name: String, console: Console): Course? {
    if (isCourseLink(name)) return linkedCourse(name, console)
    return when (val reading = readCourseFile(name, console.language)) {
        is CourseReading.Failure -> {
            console.complain(reading.reason)
            null
        }

        is CourseReading.Success -> {
            when (val result = reading.result) {
                is CourseFileResult.Success -> {
                    console.warn(name, emptyList(), result.warnings)
                    result.course
                }

                is CourseFileResult.Failure -> {
                    console.complain("$name: ${result.message}")
                    null
                }
            }
        }
    }
}

private fun linkedCourse(link: String, console: Console): Course? =
    when (val result = runBlocking { openLink(link, console.language) }) {
        is LinkResult.OfCourse -> result.course

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
private class FilesBeside(private val course: Path, private val messages: CommandMessages) {
    /** Why a file that is there could not be read. */
    var problem: String? = null
        private set

    fun read(name: String): ByteArray? {
        val path = try {
            course.resolveSibling(name).takeIf { it.exists() } ?: return null
        } catch (_: InvalidPathException) {
            return null
        }
        val content = reading(name, messages, FileContent::Failure) {
            val isInside = course.toAbsolutePath().parent?.let { liesIn(it, path) } ?: false
            if (isInside) {
                readContent(path, name, LARGEST_FILE_BYTES, messages)
            } else {
                FileContent.Failure(messages.leadsOutside(name))
            }
        }
        if (content is FileContent.Failure) problem = content.reason
        return (content as? FileContent.Success)?.bytes
    }
}
