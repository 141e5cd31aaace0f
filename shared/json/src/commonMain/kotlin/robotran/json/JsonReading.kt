package robotran.json

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.json.messages.JsonMessages
import robotran.language.Language

/** The result of reading a JSON file. */
sealed interface JsonReading<out T> {
    data class Read<out T>(val value: T) : JsonReading<T>

    /**
     * The file is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error, from 1; null if the error concerns the whole file.
     * @property path the value with the error, such as `walls[2].from`; empty if none.
     */
    data class Rejected(val message: String, val line: Int?, val path: String) : JsonReading<Nothing>
}

/**
 * Reads a JSON file with [read], which extracts the values and rejects invalid ones with a [JsonValidationException].
 * Returns quickly for any text, because length and nesting depth are checked before parsing.
 *
 * @param language the language of error messages.
 */
fun <T> readJson(text: String, language: Language = Language.ENGLISH, read: (JsonCursor) -> T): JsonReading<T> {
    val json = text.removePrefix(BYTE_ORDER_MARK)
    return try {
        checkJsonLimits(json)
        val file = JsonCursor(Json.parseToJsonElement(json), JsonPath.WHOLE_FILE)
        file.checkLiterals()
        JsonReading.Read(read(file))
    } catch (refusal: JsonValidationException) {
        refusedBecause(refusal, json, language)
    } catch (diagnostic: SerializationException) {
        val line = lineAt(json, offsetOf(diagnostic) ?: json.length)
        JsonReading.Rejected(JsonMessages.of(language).notReadable(line), line, "")
    } catch (excess: LimitExceeded) {
        JsonReading.Rejected(excess.sentence(language), excess.line, "")
    }
}

/** The same for the bytes of a file: UTF-8, with or without a byte order mark. */
fun <T> readJson(bytes: ByteArray, language: Language = Language.ENGLISH, read: (JsonCursor) -> T): JsonReading<T> {
    val text = if (bytes.size > JsonLimits.MAXIMUM_BYTES) {
        return JsonReading.Rejected(JsonMessages.of(language).fileTooLong(JsonLimits.MAXIMUM_CHARACTERS), null, "")
    } else {
        try {
            bytes.decodeToString(throwOnInvalidSequence = true)
        } catch (_: CharacterCodingException) {
            return JsonReading.Rejected(JsonMessages.of(language).notUtf8(), null, "")
        }
    }
    return readJson(text, language, read)
}

private fun refusedBecause(refusal: JsonValidationException, text: String, language: Language): JsonReading.Rejected {
    val path = refusal.path ?: return JsonReading.Rejected(refusal.reason(language), null, "")
    val line = lineOf(path, text)
    val messages = JsonMessages.of(language)
    val reason = refusal.reason(language)
    val sentence =
        if (refusal.isSentence) messages.at(line, "$path", reason) else messages.refused(line, "$path", reason)
    return JsonReading.Rejected(sentence, line, path.toString())
}

/** The parser reports the offset of an error only in its message, and not at all if the file ends too early. */
private fun offsetOf(diagnostic: SerializationException): Int? =
    Regex("offset (\\d+)").find(diagnostic.message.orEmpty())?.groupValues?.get(1)?.toIntOrNull()

private const val BYTE_ORDER_MARK = "\uFEFF"
