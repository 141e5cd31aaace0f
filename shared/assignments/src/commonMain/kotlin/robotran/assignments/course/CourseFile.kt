package robotran.assignments.course

import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.assignments.messages.CourseMessages
import robotran.documents.ZipEntry
import robotran.json.JsonCursor
import robotran.json.JsonReading
import robotran.json.JsonValidationException
import robotran.json.jsonObject
import robotran.json.readJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.projects.MULTILINE_PROJECT_LISTS
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.elementOf
import robotran.projects.projectIn
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.world.UnknownFields
import robotran.world.WorldLimits
import robotran.world.file.unknownOf

/** The result of reading a course. */
sealed interface CourseFileResult {
    data class Loaded(val course: Course) : CourseFileResult

    /**
     * The course is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error in [file], from 1; null if it concerns the whole file.
     * @property file the name of the file in the folder; null if there is only one.
     */
    data class Rejected(val message: String, val line: Int? = null, val file: String? = null) : CourseFileResult
}

/** Whether [text] looks like the file of a course rather than that of a project or a world. */
fun isCourse(text: String): Boolean = "\"$COURSE_FORMAT\"" in text

/** Reads a course in one file. Returns quickly for any text. */
fun readCourse(text: String, language: Language = Language.ENGLISH): CourseFileResult =
    resultOf(readJson(text, language) { head(it).with(inlineAssignments(it)) }, null)

/**
 * Reads a course in a folder: `course.json` and the files that it names.
 *
 * @param files by name.
 */
fun readCourseFolder(files: Map<String, ByteArray>, language: Language = Language.ENGLISH): CourseFileResult {
    val messages = CourseMessages.of(language)
    val main = files[COURSE_FILE] ?: return CourseFileResult.Rejected(messages.noCourseFile(COURSE_FILE))
    val listing = when (val reading = readJson(main, language) { head(it) to namesIn(it) }) {
        is JsonReading.Read -> reading.value
        is JsonReading.Rejected -> return CourseFileResult.Rejected(reading.message, reading.line, COURSE_FILE)
    }
    val assignments = listing.second.map { name ->
        val bytes = files[name] ?: return CourseFileResult.Rejected(messages.missingFile(name), file = COURSE_FILE)
        when (val result = readProject(bytes, language)) {
            is ProjectFileResult.Rejected -> return CourseFileResult.Rejected(result.message, result.line, name)
            is ProjectFileResult.Loaded -> result.project
        }
    }
    val wrong = assignments.indexOfFirst { it.assignment == null }
    if (wrong >= 0) return CourseFileResult.Rejected(messages.mustBeAssignment(), file = listing.second[wrong])
    val twice = idTwice(assignments) ?: return CourseFileResult.Loaded(listing.first.with(assignments))
    return CourseFileResult.Rejected(messages.idTwice(twice), file = COURSE_FILE)
}

/** [course] as one file. [readCourse] restores the same course. */
fun writeCourse(course: Course): String =
    writeJson(elementOf(course, course.assignments.map(::elementOf)), MULTILINE_PROJECT_LISTS)

/** [course] as the files of a folder, see [readCourseFolder]. */
fun courseFolder(course: Course): List<ZipEntry> {
    val digits = course.assignments.size.toString().length.coerceAtLeast(2)
    val names = course.assignments.mapIndexed { index, project ->
        val title = project.world.title.map { if (it.isLetterOrDigit()) it.lowercaseChar() else '-' }.joinToString("")
        val plain = title.split('-').filter { it.isNotEmpty() }.joinToString("-").take(LONGEST_NAME)
        "${"${index + 1}".padStart(digits, '0')}-${plain.ifEmpty { "assignment" }}.robotran"
    }
    val listing = writeJson(elementOf(course, names.map(::JsonPrimitive)), MULTILINE_PROJECT_LISTS)
    return listOf(ZipEntry(COURSE_FILE, listing.encodeToByteArray())) +
        course.assignments.zip(names) { project, name -> ZipEntry(name, writeProject(project).encodeToByteArray()) }
}

private class Head(val title: String, val text: String, val unknown: UnknownFields) {
    fun with(assignments: List<Project>) = Course(title, text, assignments, unknown)
}

/** Reads all but the assignments. */
private fun head(file: JsonCursor): Head {
    if (file.optional("format")?.textOrNull() != COURSE_FORMAT) {
        throw JsonValidationException(null) { CourseMessages.of(it).notACourse(COURSE_FORMAT) }
    }
    val version = file.member("version").wholeNumber(1..Int.MAX_VALUE)
    if (version > COURSE_VERSION) {
        throw JsonValidationException(null) { CourseMessages.of(it).newerCourse(version, COURSE_VERSION) }
    }
    val title = file.member("title").text(WorldLimits.MAXIMUM_TITLE_CHARACTERS)
    val lines = file.optional("text")?.items(1..ProjectLimits.MAXIMUM_LINES).orEmpty().map { line ->
        line.text(CourseLimits.MAXIMUM_TEXT_CHARACTERS, mayBeEmpty = true)
    }
    file.member("assignments")
    return Head(title, lines.joinToString("\n"), unknownOf(file))
}

private fun inlineAssignments(file: JsonCursor): List<Project> {
    val places = file.member("assignments").items(1..CourseLimits.MAXIMUM_ASSIGNMENTS)
    val assignments = places.map { place ->
        projectIn(place).also { project ->
            if (project.assignment == null) place.refuse { CourseMessages.of(it).mustHaveAssignment() }
        }
    }
    idTwice(assignments)?.let { id -> file.refuse { CourseMessages.of(it).idTwice(id) } }
    return assignments
}

private fun namesIn(file: JsonCursor): List<String> =
    file.member("assignments").items(1..CourseLimits.MAXIMUM_ASSIGNMENTS).map {
        it.text(ProjectLimits.MAXIMUM_NAME_CHARACTERS)
    }

/** Progress is kept by these. */
private fun idTwice(assignments: List<Project>): String? =
    assignments.mapNotNull { it.assignment?.id }.groupBy { it }.values.firstOrNull { it.size > 1 }?.first()

private fun elementOf(course: Course, assignments: List<JsonElement>): JsonObject = jsonObject(course.unknown.members) {
    text("format", COURSE_FORMAT)
    number("version", COURSE_VERSION)
    text("title", course.title)
    list("text", course.text.takeIf { it.isNotEmpty() }?.split('\n').orEmpty(), ::JsonPrimitive)
    list("assignments", assignments) { it }
}

private fun resultOf(reading: JsonReading<Course>, file: String?): CourseFileResult = when (reading) {
    is JsonReading.Read -> CourseFileResult.Loaded(reading.value)
    is JsonReading.Rejected -> CourseFileResult.Rejected(reading.message, reading.line, file)
}

/** The file of a folder that lists the others. */
const val COURSE_FILE = "course.json"

internal const val COURSE_FORMAT = "robotran-course"
internal const val COURSE_VERSION = 1
private const val LONGEST_NAME = 40
