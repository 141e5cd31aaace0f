package robotran.json

import kotlinx.serialization.json.Json
import robotran.json.messages.JsonMessages
import robotran.language.Language
import robotran.language.TextEncoding
import robotran.language.decodeText

/** The result of reading a JSON file. */
sealed interface JsonReading<out T> {
    /** @property warnings about what the file says in vain, at most [JsonLimits.MAXIMUM_WARNINGS]. */
    data class Success<out T>(val value: T, val warnings: List<JsonWarning> = emptyList()) : JsonReading<T>

    /**
     * The file is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error, from 1; null if the error concerns the whole file.
     * @property path the value with the error, such as `walls[2].from`; empty if none.
     */
    data class Failure(val message: String, val line: Int?, val path: String) : JsonReading<Nothing>
}

/**
 * Something in a file that can be read, but is probably a mistake, such as a field that is spelt wrong.
 *
 * @property message one sentence with location and reason.
 * @property line from 1; null if the warning concerns the whole file.
 * @property path the field, such as `walls[2].thicknes`; empty if none.
 */
data class JsonWarning(val message: String, val line: Int? = null, val path: String = "")

/**
 * Reads a JSON file with [read], which extracts the values and rejects invalid ones with a [JsonValidationException].
 * Returns quickly for any text, because length and nesting depth are checked before parsing. A field that [read] has not
 * asked for is ignored; if its name is near one that it has asked for, a warning says so.
 *
 * @param language the language of error messages.
 */
fun <T> readJson(text: String, language: Language, read: (JsonCursor) -> T): JsonReading<T> {
    val json = text.removePrefix(BYTE_ORDER_MARK)
    return try {
        val doubled = JsonSyntax(json).check()
        val questions = JsonQuestions()
        val value = read(JsonCursor(Json.parseToJsonElement(json), JsonPath.WHOLE_FILE, questions))
        JsonReading.Success(value, warningsOf(doubled, questions.misspelt(), json, language))
    } catch (refusal: JsonValidationException) {
        refusedBecause(refusal, json, language)
    } catch (error: JsonSyntaxException) {
        JsonReading.Failure(error.sentence(language), error.line, "")
    }
}

/** The same for the bytes of a file, in any encoding that [decodeText] knows. */
fun <T> readJson(bytes: ByteArray, language: Language, read: (JsonCursor) -> T): JsonReading<T> {
    val messages = JsonMessages.of(language)
    if (bytes.size > JsonLimits.MAXIMUM_BYTES) {
        return JsonReading.Failure(messages.fileTooLong(JsonLimits.MAXIMUM_CHARACTERS), null, "")
    }
    val decoded = decodeText(bytes) ?: return JsonReading.Failure(messages.notText(), null, "")
    val reading = readJson(decoded.text, language, read)
    if (reading !is JsonReading.Success || decoded.encoding == TextEncoding.UTF_8) return reading
    val warning = JsonWarning(messages.otherEncoding(decoded.encoding.ownName))
    return reading.copy(warnings = (listOf(warning) + reading.warnings).take(JsonLimits.MAXIMUM_WARNINGS))
}

private fun warningsOf(
    doubled: List<JsonPath>,
    misspelt: List<MisspeltField>,
    text: String,
    language: Language,
): List<JsonWarning> {
    val messages = JsonMessages.of(language)
    val found = doubled.map { it to messages.twice() } + misspelt.map { it.path to messages.misspelt(it.known) }
    return found.take(JsonLimits.MAXIMUM_WARNINGS).map { (path, reason) ->
        val line = lineOf(path, text)
        JsonWarning(messages.refused(line, "$path", reason), line, "$path")
    }
}

private fun refusedBecause(refusal: JsonValidationException, text: String, language: Language): JsonReading.Failure {
    val path = refusal.path ?: return JsonReading.Failure(refusal.reason(language), null, "")
    val line = lineOf(path, text)
    val messages = JsonMessages.of(language)
    val reason = refusal.reason(language)
    val sentence = when (refusal.form) {
        JsonValidationException.Form.REASON -> messages.refused(line, "$path", reason)
        JsonValidationException.Form.SENTENCE -> messages.at(line, "$path", reason)
        JsonValidationException.Form.WHOLE -> messages.inLine(line, reason)
    }
    return JsonReading.Failure(sentence, line, path.toString())
}

private const val BYTE_ORDER_MARK = "\uFEFF"
