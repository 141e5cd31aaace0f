package robotran.json

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.json.messages.JsonMessages
import robotran.language.Language

/** What came of reading a JSON file. */
sealed interface JsonReading<out T> {
    data class Read<out T>(val value: T) : JsonReading<T>

    /**
     * The file cannot be used.
     *
     * @property message one sentence that says where and why.
     * @property line the line it is about, from 1; null if it is about the file as a whole.
     * @property path the value it is about, such as `walls[2].from`; empty if it is about none.
     */
    data class Rejected(val message: String, val line: Int?, val path: String) : JsonReading<Nothing>
}

/**
 * Reads a JSON file with [read], which takes what it wants from the whole file and refuses the rest with a
 * [JsonValidationException]. Whatever the text is, this ends quickly: its length and the depth of its brackets are
 * bounded before it is taken apart.
 *
 * @param language what a refusal is told in.
 */
fun <T> readJson(text: String, language: Language = Language.ENGLISH, read: (JsonCursor) -> T): JsonReading<T> {
    val json = text.removePrefix(BYTE_ORDER_MARK)
    return try {
        boundJson(json)
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

/** The same for a file as it lies on a disk: text in UTF-8, with or without a byte order mark. */
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
    val sentence = JsonMessages.of(language).refused(line, path.toString(), refusal.reason(language))
    return JsonReading.Rejected(sentence, line, path.toString())
}

/** The parser tells the place of a mistake only in its message, and not at all if the file ends too early. */
private fun offsetOf(diagnostic: SerializationException): Int? =
    Regex("offset (\\d+)").find(diagnostic.message.orEmpty())?.groupValues?.get(1)?.toIntOrNull()

private const val BYTE_ORDER_MARK = "\uFEFF"
