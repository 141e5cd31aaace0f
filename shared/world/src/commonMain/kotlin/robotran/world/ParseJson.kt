package robotran.world

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json

/** Parses a file of bounded length and depth, so that its size cannot exhaust the memory nor its nesting the stack. */
internal fun parseJson(text: String): JsonPlace {
    if (text.length > WorldLimits.MAXIMUM_CHARACTERS) {
        throw WorldRefusal("The world file is too long: more than ${WorldLimits.MAXIMUM_CHARACTERS} characters.")
    }
    refuseDeepNesting(text)
    try {
        return JsonPlace(Json.parseToJsonElement(text), "")
    } catch (mistake: SerializationException) {
        throw WorldRefusal("${lineOf(mistake, text)} cannot be read: something is missing or out of place there.")
    }
}

private fun refuseDeepNesting(text: String) {
    var depth = 0
    var line = 1
    var inString = false
    var escaped = false
    for (character in text) {
        if (character == '\n') line++
        if (inString) {
            inString = escaped || character != '"'
            escaped = !escaped && character == '\\'
        } else {
            when (character) {
                '"' -> inString = true
                '{', '[' -> depth++
                '}', ']' -> depth--
            }
        }
        if (depth > WorldLimits.MAXIMUM_DEPTH) {
            throw WorldRefusal("Line $line of the world file opens too many brackets inside one another.")
        }
    }
}

/** The parser tells the place of a mistake only in its message, and not at all if the file ends too early. */
private fun lineOf(mistake: SerializationException, text: String): String {
    val offset = Regex("offset (\\d+)").find(mistake.message.orEmpty())?.groupValues?.get(1)?.toIntOrNull() ?: text.length
    return "Line ${1 + text.take(offset).count { it == '\n' }} of the world file"
}
