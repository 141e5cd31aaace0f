package robotran.json

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.JsonUnquotedLiteral

/**
 * [element] as text for people and for merging: what fits into a line is on one, but each object in a list is on a line
 * of its own. Ends with a line end.
 *
 * @param tall the names of members whose lists have each entry on a line of its own, as lines of a text.
 */
fun writeJson(element: JsonElement, tall: Set<String> = emptySet()): String = buildString {
    JsonWriter(this, tall).write(element, indent = 0, before = 0)
    append('\n')
}

/** [element] as short as it can be. */
fun writeCompactJson(element: JsonElement): String =
    buildString { JsonWriter(this, emptySet(), blank = "").writeOnOneLine(element) }

/** A number as every target writes it. */
@OptIn(ExperimentalSerializationApi::class)
fun decimal(number: Double): JsonElement = JsonUnquotedLiteral(writeDecimal(number))

/** These members, and what [JsonCursor.rest] has kept of an object. */
fun JsonObject.withRest(rest: Map<String, JsonElement>): JsonObject = if (rest.isEmpty()) {
    this
} else {
    JsonObject(
        this + rest.mapNotNull { (name, kept) ->
            val own = this[name]
            when {
                own == null -> name to kept
                own is JsonObject && kept is JsonObject -> name to own.withRest(kept)
                else -> null
            }
        },
    )
}

private class JsonWriter(
    private val out: StringBuilder,
    private val tall: Set<String>,
    private val blank: String = " ",
) {
    /** @param before how much of the line is taken already, beside the indentation. */
    fun write(element: JsonElement, indent: Int, before: Int) {
        when {
            element is JsonPrimitive || (
                !mustBreak(
                    element,
                    indent,
                ) && fits(element, indent + before)
            ) -> writeOnOneLine(element)

            element is JsonObject -> lines(element.entries, "{", "}", indent) { (name, value) ->
                writeText(name)
                out.append(": ")
                if (isTall(name, value)) {
                    lines(value as JsonArray, "[", "]", indent + INDENT) {
                        write(it, indent + INDENT + INDENT, before = 0)
                    }
                } else {
                    write(value, indent + INDENT, before = name.length + NAME_MARKS)
                }
            }

            element is JsonArray -> lines(element, "[", "]", indent) { write(it, indent + INDENT, before = 0) }

            else -> writeOnOneLine(element)
        }
    }

    fun writeOnOneLine(element: JsonElement) {
        when (element) {
            is JsonObject -> group(element.entries, "{$blank", "$blank}") { (name, value) ->
                writeText(name)
                out.append(':').append(blank)
                writeOnOneLine(value)
            }

            is JsonArray -> group(element, "[", "]") { writeOnOneLine(it) }

            is JsonPrimitive -> if (element.isString) writeText(element.content) else out.append(element.content)
        }
    }

    /** All that is around a list of objects or a tall one breaks with it. */
    private fun mustBreak(element: JsonElement, indent: Int): Boolean = when (element) {
        is JsonObject -> element.isNotEmpty() &&
            (indent == 0 || element.any { (name, value) -> isTall(name, value) || mustBreak(value, INDENT) })

        is JsonArray -> element.any { it is JsonObject || mustBreak(it, INDENT) }

        is JsonPrimitive -> false
    }

    private fun isTall(name: String, value: JsonElement) = name in tall && value is JsonArray && value.isNotEmpty()

    /**
     * Tried on paper of its own: to take something back from a long text costs as much as all of it on some platforms.
     */
    private fun fits(element: JsonElement, before: Int): Boolean {
        val room = LINE - before
        if (!isShort(element, room)) return false
        val tried = StringBuilder()
        JsonWriter(tried, tall, blank).writeOnOneLine(element)
        return tried.length <= room
    }

    /** Looks no further than it must, so that nothing long is written once for every bracket around it. */
    private fun isShort(element: JsonElement, room: Int): Boolean = minLength(element, room) <= room

    private fun minLength(element: JsonElement, room: Int): Int = when (element) {
        is JsonPrimitive -> element.content.length
        is JsonArray -> minLengthOf(element, room)
        is JsonObject -> minLengthOf(element.values, room)
    }

    private fun minLengthOf(items: Collection<JsonElement>, room: Int): Int {
        var length = 2
        for (item in items) {
            length += 1 + minLength(item, room - length)
            if (length > room) return length
        }
        return length
    }

    private inline fun <T> lines(items: Collection<T>, open: String, close: String, indent: Int, write: (T) -> Unit) {
        out.append(open)
        items.forEachIndexed { number, item ->
            out.append(if (number == 0) "\n" else ",\n").append(" ".repeat(indent + INDENT))
            write(item)
        }
        out.append('\n').append(" ".repeat(indent)).append(close)
    }

    private inline fun <T> group(items: Collection<T>, open: String, close: String, write: (T) -> Unit) {
        if (items.isEmpty()) {
            out.append(open.trim()).append(close.trim())
            return
        }
        out.append(open)
        items.forEachIndexed { number, item ->
            if (number > 0) out.append(',').append(blank)
            write(item)
        }
        out.append(close)
    }

    /** Escapes what JSON asks for, and halves of characters, which do not survive being saved. */
    private fun writeText(text: String) {
        out.append('"')
        text.forEachIndexed { place, character ->
            when {
                character == '"' || character == '\\' -> out.append('\\').append(character)
                character == '\n' -> out.append("\\n")
                character == '\t' -> out.append("\\t")
                character < ' ' || isHalfCharacter(text, place) -> out.append("\\u").append(hexadecimal(character))
                else -> out.append(character)
            }
        }
        out.append('"')
    }

    private fun hexadecimal(character: Char): String = character.code.toString(radix = 16).padStart(UNICODE_DIGITS, '0')

    private companion object {
        const val INDENT = 2
        const val LINE = 120

        /** Two quotes, colon and blank. */
        const val NAME_MARKS = 4
        const val UNICODE_DIGITS = 4
    }
}
