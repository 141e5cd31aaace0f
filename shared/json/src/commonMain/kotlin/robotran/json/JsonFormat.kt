package robotran.json

import robotran.json.messages.JsonMessages
import robotran.language.Language

/**
 * A file format of ours: each file names it and its version.
 *
 * @property name what the field `format` says.
 * @property version the newest that can be read.
 * @property isOther the sentence that a file is of another format.
 * @property isNewer the sentence that a file has a newer version.
 */
class JsonFormat(
    val name: String,
    val version: Int,
    private val isOther: (Language) -> String,
    private val isNewer: (version: Int) -> (Language) -> String,
) {
    /**
     * The version of the file at [cursor].
     *
     * @throws JsonValidationException if it is of another format or too new.
     */
    fun versionOf(cursor: JsonCursor): Int {
        val format = cursor.optional("format")
        if (format?.textOrNull() != name) {
            if (format == null && cursor.path.steps.isEmpty()) throw JsonValidationException(null, isOther)
            (format ?: cursor).refuseLine(isOther)
        }
        val field = cursor.member("version")
        val found = field.wholeNumber(0..Int.MAX_VALUE)
        if (found < 1) field.refuse { JsonMessages.of(it).mustBeFrom("1", "$version") }
        if (found > version) field.refuseLine(isNewer(found))
        return found
    }
}
