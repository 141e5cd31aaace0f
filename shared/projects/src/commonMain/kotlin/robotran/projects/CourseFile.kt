package robotran.projects

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import robotran.json.JsonCursor
import robotran.json.JsonFormat
import robotran.json.JsonLimits
import robotran.json.JsonReading
import robotran.json.JsonValidationException
import robotran.json.JsonWarning
import robotran.json.jsonObject
import robotran.json.readJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.projects.messages.reason
import robotran.world.WorldLimits
import robotran.world.file.MULTILINE_LISTS
import robotran.world.file.unknownOf

/** The result of reading a course file. */
sealed interface CourseFileResult {
    /** @property warnings about fields that are probably misspelt, also in the files of its assignments. */
    data class Success(val course: Course, val warnings: List<JsonWarning> = emptyList()) : CourseFileResult

    /**
     * The file is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error, from 1; null if the error concerns the whole file.
     * @property path the field of the error, such as `assignments[2].world.title`; empty if none.
     */
    data class Failure(val message: String, val line: Int? = null, val path: String = "") : CourseFileResult
}

/**
 * Reads a course file; `docs/assignments.md` describes the format. Returns quickly for any text.
 *
 * @param language the language of error messages.
 * @param beside the bytes of the project file with this name, which lies beside the course file; null if there is none.
 */
fun readCourse(text: String, language: Language, beside: (name: String) -> ByteArray? = { null }): CourseFileResult =
    FilesBeside(language, beside).let { files ->
        resultOf(readJson(text, language) { courseIn(it, files) }, files)
    }

/** The same for the bytes of a file, in any encoding that [robotran.language.decodeText] knows. */
fun readCourse(
    bytes: ByteArray,
    language: Language,
    beside: (name: String) -> ByteArray? = { null },
): CourseFileResult = FilesBeside(language, beside).let { files ->
    resultOf(readJson(bytes, language) { courseIn(it, files) }, files)
}

/** [course] as one file with all its assignments, readable and easy to merge. [readCourse] restores the same course. */
fun writeCourse(course: Course): String = writeJson(elementOf(course), MULTILINE_LISTS + TEXT)

/** The names of the files that the course file [text] mentions; empty if it is invalid. */
fun assignmentFilesOf(text: String): List<String> {
    val reading = readJson(text, Language.ENGLISH) { file ->
        file.optional(ASSIGNMENTS)?.items(0..Course.MAXIMUM_ASSIGNMENTS).orEmpty().mapNotNull { it.textOrNull() }
    }
    return (reading as? JsonReading.Success)?.value.orEmpty()
}

/** Whether the JSON file [text] claims to be a course. */
fun isCourseFile(text: String): Boolean = COURSE_MARK in text

private fun courseIn(file: JsonCursor, beside: FilesBeside): Course {
    FORMAT.versionOf(file)
    val ids = mutableSetOf<String>()
    return Course(
        title = file.member("title").text(WorldLimits.MAXIMUM_TITLE_CHARACTERS),
        text = file.optional(TEXT)?.let { textIn(it, AssignmentLimits.MAXIMUM_TEXT_CHARACTERS) }.orEmpty(),
        assignments = file.member(ASSIGNMENTS).items(1..Course.MAXIMUM_ASSIGNMENTS).map { place ->
            val project = assignmentAt(place, beside)
            val assignment = project.assignment
            if (assignment == null || project.handIn != null) place.refuse(reason { mustBeAssignment() })
            if (!ids.add(assignment.id)) place.refuse(reason { assignmentTwice(assignment.id) })
            project
        },
        id = file.optional("id")?.text(AssignmentLimits.MAXIMUM_ID_CHARACTERS).orEmpty(),
        unknown = unknownOf(file),
    )
}

private fun assignmentAt(cursor: JsonCursor, beside: FilesBeside): Project {
    if (cursor.textOrNull() == null) return projectIn(cursor)
    val name = cursor.text(ProjectLimits.MAXIMUM_NAME_CHARACTERS)
    if (name.any { it in FOLDERS }) cursor.refuse(reason { mustBeFileName() })
    return beside.read(name) ?: cursor.refuse(reason { fileNotBeside(name) })
}

/** The project files beside a course file. */
private class FilesBeside(private val language: Language, private val bytesOf: (name: String) -> ByteArray?) {
    val warnings = mutableListOf<JsonWarning>()

    /** The project in the file [name]; null if there is none. */
    fun read(name: String): Project? {
        val bytes = bytesOf(name) ?: return null
        return when (val result = readProject(bytes, language)) {
            is ProjectFileResult.Success -> {
                warnings += result.warnings.map { JsonWarning("$name: ${it.message}") }
                result.project
            }

            is ProjectFileResult.Failure -> throw JsonValidationException(null) { "$name: ${result.message}" }
        }
    }
}

internal fun elementOf(course: Course): JsonObject = jsonObject(course.unknown.members) {
    text("format", COURSE_FORMAT)
    number("version", COURSE_VERSION)
    text("id", course.id, default = "")
    text("title", course.title)
    put(TEXT, course.text.takeIf { it.isNotEmpty() }?.let(::linesOf))
    put(ASSIGNMENTS, JsonArray(course.assignments.map(::elementOf)))
}

private fun resultOf(reading: JsonReading<Course>, beside: FilesBeside): CourseFileResult = when (reading) {
    is JsonReading.Success -> CourseFileResult.Success(
        reading.value,
        (reading.warnings + beside.warnings).take(JsonLimits.MAXIMUM_WARNINGS),
    )

    is JsonReading.Failure -> CourseFileResult.Failure(reading.message, reading.line, reading.path)
}

private const val COURSE_FORMAT = "robotran-course"
private const val COURSE_MARK = "\"$COURSE_FORMAT\""
private const val COURSE_VERSION = 1
private val FORMAT = JsonFormat(
    COURSE_FORMAT,
    COURSE_VERSION,
    reason { notACourse(COURSE_FORMAT) },
    { version -> reason { newerCourse(version, COURSE_VERSION) } },
)
private const val ASSIGNMENTS = "assignments"
private const val FOLDERS = "/\\"
