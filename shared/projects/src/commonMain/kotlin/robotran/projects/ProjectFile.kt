package robotran.projects

import robotran.json.JsonLimits
import robotran.json.JsonReading
import robotran.json.JsonWarning
import robotran.json.readJson
import robotran.json.writeCompactJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.world.file.MULTILINE_LISTS

/** The result of reading a project file. */
sealed interface ProjectFileResult {
    /** @property warnings about fields that are probably misspelt. */
    data class Success(val project: Project, val warnings: List<JsonWarning> = emptyList()) : ProjectFileResult

    /**
     * The file is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error, from 1; null if the error concerns the whole file.
     * @property path the field of the error, such as `world.walls[2].thickness`; empty if none.
     */
    data class Failure(val message: String, val line: Int? = null, val path: String = "") : ProjectFileResult
}

/**
 * Reads a project file, `.robotran`; `docs/worlds.md` describes the format. Returns quickly for any text.
 *
 * @param language the language of error messages.
 */
fun readProject(text: String, language: Language): ProjectFileResult =
    resultOf(readJson(text, language) { projectIn(it) })

/** The same for the bytes of a file, in any encoding that [robotran.language.decodeText] knows. */
fun readProject(bytes: ByteArray, language: Language): ProjectFileResult =
    resultOf(readJson(bytes, language) { projectIn(it) })

/**
 * [project] as a file, readable and easy to merge. [readProject] restores the same project if its numbers have at most
 * fifteen digits.
 */
fun writeProject(project: Project): String {
    val element = elementOf(project)
    val readable = writeJson(element, MULTILINE_LISTS + TEXT)
    // What was read must be written again, even if there is no room for indentation.
    return if (readable.length <= JsonLimits.MAXIMUM_CHARACTERS) readable else writeCompactJson(element) + "\n"
}

/** How many characters the programs of [project] may take in its file, see [charactersInFile]. */
fun roomForPrograms(project: Project): Int =
    JsonLimits.MAXIMUM_CHARACTERS - MARGIN - writeCompactJson(elementOf(project.copy(robots = emptyList()))).length

/** How many characters [text] takes at most as a program in a project's file that has no room to spare. */
fun charactersInFile(text: String): Int = LINE_MARKS + text.sumOf { letter ->
    when {
        letter == '\n' -> LINE_MARKS
        letter < ' ' -> ESCAPE
        letter == '"' || letter == '\\' -> 2
        else -> 1
    }
}

/**
 * What a hand-in's link holds: the project without white space, and without its world unless the assignment allows to
 * change that.
 */
fun writeCompactHandIn(project: Project): String = writeCompactJson(handInElementOf(project))

internal fun resultOf(reading: JsonReading<Project>): ProjectFileResult = when (reading) {
    is JsonReading.Success -> ProjectFileResult.Success(reading.value, reading.warnings)
    is JsonReading.Failure -> ProjectFileResult.Failure(reading.message, reading.line, reading.path)
}

/** For the names of robots, programs and files. */
private const val MARGIN = 50_000

/** The quotes of a line and its comma. */
private const val LINE_MARKS = 3
private const val ESCAPE = 6

internal const val PROJECT_FORMAT = "robotran-project"
internal const val PROJECT_VERSION = 1

/** The member with the lines of a program's file. */
internal const val TEXT = "text"

/** The field with the language of people whose words a program has. */
internal const val WORDS = "words"
