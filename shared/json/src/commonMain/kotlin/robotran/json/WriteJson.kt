package robotran.json

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.JsonUnquotedLiteral

/**
 * [element] as text that is readable and easy to merge: values that fit are on one line, but each object in a list is
 * on its own line. Ends with a line feed.
 *
 * @param tall the names of lists with one item per line, such as lines of a text.
 */
fun writeJson(element: JsonElement, tall: Set<String> = emptySet()): String = buildString {
    JsonWriter(this, tall).write(element, indent = 0, before = 0)
    append('\n')
}

/** [element] without white space. */
fun writeCompactJson(element: JsonElement): String =
    buildString { JsonWriter(this, emptySet(), blank = "").writeOnOneLine(element) }

/** A number in the same notation on every target. */
@OptIn(ExperimentalSerializationApi::class)
fun decimal(number: Double): JsonElement = JsonUnquotedLiteral(writeDecimal(number))

/** These members and the unread ones from [JsonCursor.rest]. */
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
    /** @param before length of the line so far, without the indentation. */
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

    /** A list of objects or a tall list breaks all enclosing values. */
    private fun mustBreak(element: JsonElement, indent: Int): Boolean = when (element) {
        is JsonObject -> element.isNotEmpty() &&
            (indent == 0 || element.any { (name, value) -> isTall(name, value) || mustBreak(value, INDENT) })

        is JsonArray -> element.any { it is JsonObject || mustBreak(it, INDENT) }
        is JsonPrimitive -> false
    }

    private fun isTall(name: String, value: JsonElement) = name in tall && value is JsonArray && value.isNotEmpty()

    /** Uses a separate buffer, because truncating a long text copies all of it on some platforms. */
    private fun fits(element: JsonElement, before: Int): Boolean {
        val room = LINE - before
        if (!isShort(element, room)) return false
        val tried = StringBuilder()
        JsonWriter(tried, tall, blank).writeOnOneLine(element)
        return tried.length <= room
    }

    /** Stops early, so that a long value is not measured again for every enclosing bracket. */
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

    /** Escapes as JSON requires, and unpaired surrogates, which UTF-8 cannot store. */
    private fun writeText(text: String) {
        out.append('"')
        text.forEachIndexed { place, character ->
            when {
                character == '"' || character == '\\' -> out.append('\\').append(character)
                character == '\n' -> out.append("\\n")
                character == '\t' -> out.append("\\t")
                character < ' ' || isUnpairedSurrogate(text, place) -> out.append("\\u").append(hexadecimal(character))
                else -> out.append(character)
            }
        }
        out.append('"')
    }

    private companion object {
        const val INDENT = 2
        const val LINE = 120

        /** Two quotes, colon and blank. */
        const val NAME_MARKS = 4
    }
}
