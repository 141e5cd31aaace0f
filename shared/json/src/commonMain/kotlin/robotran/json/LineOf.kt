package robotran.json

/**
 * The line, from 1, of the value at [path] in the JSON [text], or of the nearest enclosing one if it is missing. The
 * parser does not keep positions, so this scans the text again, only after an error. Of duplicate names the last one
 * counts, as in the parser.
 */
internal fun lineOf(path: JsonPath, text: String): Int {
    val scanner = JsonScanner(text)
    var value = scanner.skipBlanks(0)
    var offset = value
    for (step in path.steps) {
        val found = when (step) {
            is JsonStep.Member -> scanner.findMember(value, step.name)
            is JsonStep.Item -> scanner.findItem(value, step.number)
        } ?: break
        offset = found.offset
        value = found.value
    }
    return lineAt(text, offset)
}

/** @property offset the offset to report: that of a member's name, because its value may start a later line. */
private class Found(val offset: Int, val value: Int)

/** Scans a text that is valid JSON. Positions are character offsets. */
private class JsonScanner(private val text: String) {
    fun skipBlanks(from: Int): Int {
        var place = from
        while (at(place) == ' ' || at(place) == '\n' || at(place) == '\r' || at(place) == '\t') place++
        return place
    }

    fun findMember(start: Int, name: String): Found? {
        if (at(start) != '{') return null
        var found: Found? = null
        var place = skipBlanks(start + 1)
        while (at(place) == '"') {
            val end = skipString(place)
            val value = skipBlanks(skipBlanks(end) + 1)
            if (unquotedJson(text, place + 1, end - 1) == name) found = Found(place, value)
            place = next(value)
        }
        return found
    }

    fun findItem(start: Int, number: Int): Found? {
        if (at(start) != '[') return null
        var place = skipBlanks(start + 1)
        repeat(number) {
            if (at(place) == ']' || at(place) == null) return null
            place = next(place)
        }
        return Found(place, place)
    }

    /** The offset after the value at [value] and an optional comma. */
    private fun next(value: Int): Int {
        val end = skipBlanks(skipValue(value))
        return if (at(end) == ',') skipBlanks(end + 1) else end
    }

    private fun skipValue(from: Int): Int {
        var depth = 0
        var place = from
        while (place < text.length) {
            when (text[place]) {
                '"' -> place = skipString(place) - 1
                '{', '[' -> depth++
                '}', ']' -> if (--depth < 0) return place
                ',' -> if (depth == 0) return place
            }
            place++
            if (depth == 0 && text[place - 1] in "\"}]") return place
        }
        return place
    }

    /** The offset after the closing quote of the string that starts at [from]. */
    private fun skipString(from: Int): Int {
        var place = from + 1
        while (place < text.length && text[place] != '"') place += if (text[place] == '\\') 2 else 1
        return minOf(place + 1, text.length)
    }

    private fun at(offset: Int): Char? = text.getOrNull(offset)
}

/** What the text in quotes says whose characters are from [from] until before [end] in [text]. */
internal fun unquotedJson(text: String, from: Int, end: Int): String = buildString {
    var place = from
    while (place < end) {
        val character = text[place]
        if (character != '\\') {
            append(character)
            place++
        } else if (text[place + 1] == 'u') {
            append(text.substring(place + UNICODE_DIGITS, place + UNICODE_END).toInt(radix = 16).toChar())
            place += UNICODE_END
        } else {
            append(ESCAPES[text[place + 1]] ?: text[place + 1])
            place += 2
        }
    }
}

/** The line, from 1, of the character at [offset]. */
internal fun lineAt(text: String, offset: Int): Int = 1 + (0..<minOf(offset, text.length)).count { text[it] == '\n' }

private const val UNICODE_DIGITS = 2
private const val UNICODE_END = 6
private val ESCAPES = mapOf('b' to '\b', 'f' to '\u000C', 'n' to '\n', 'r' to '\r', 't' to '\t')
