package robotran.projects

import robotran.json.JsonReading
import robotran.json.readJson
import robotran.json.writeJson
import robotran.language.Language
import robotran.world.file.TALL_LISTS

/** What came of reading a project file. */
sealed interface ProjectFileResult {
    data class Loaded(val project: Project) : ProjectFileResult

    /**
     * The file cannot be used.
     *
     * @property message one sentence that says where and why.
     * @property line the line it is about, from 1; null if it is about the file as a whole.
     * @property path the field it is about, such as `world.walls[2].thickness`; empty if it is about none.
     */
    data class Rejected(val message: String, val line: Int? = null, val path: String = "") : ProjectFileResult
}

/**
 * Reads a project file, `.robotran`; `docs/worlds.md` describes the format. Whatever the text is, this ends quickly and
 * with a result.
 *
 * @param language what a refusal is told in.
 */
fun readProject(text: String, language: Language = Language.ENGLISH): ProjectFileResult =
    resultOf(readJson(text, language, ::projectIn))

/** The same for a file as it lies on a disk: in UTF-8, with or without a byte order mark. */
fun readProject(bytes: ByteArray, language: Language = Language.ENGLISH): ProjectFileResult =
    resultOf(readJson(bytes, language, ::projectIn))

/**
 * [project] as a file, for people to read and to merge. [readProject] makes the same project of it, if all its numbers
 * have no more than fifteen digits.
 */
fun writeProject(project: Project): String = writeJson(elementOf(project), TALL_LISTS + TEXT)

private fun resultOf(reading: JsonReading<Project>): ProjectFileResult = when (reading) {
    is JsonReading.Read -> ProjectFileResult.Loaded(reading.value)
    is JsonReading.Rejected -> ProjectFileResult.Rejected(reading.message, reading.line, reading.path)
}

internal const val PROJECT_FORMAT = "robotran-project"
internal const val PROJECT_VERSION = 1

/** The member with the lines of a program's file. */
internal const val TEXT = "text"
