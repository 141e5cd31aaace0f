package robotran.json

import robotran.json.messages.told
import robotran.language.Language

/** A file is not even to be taken apart. */
internal class LimitExceeded(val sentence: (Language) -> String, val line: Int?) : Exception(sentence(Language.ENGLISH))

/**
 * Refuses what is too long, nests too deep or has a text in quotes that goes beyond its line, which is nearly always a
 * forgotten quote: the parser would only notice much further down.
 */
internal fun boundJson(text: String) {
    if (text.length > JsonLimits.MAXIMUM_CHARACTERS) {
        throw LimitExceeded(told { fileTooLong(JsonLimits.MAXIMUM_CHARACTERS) }, null)
    }
    var depth = 0
    var line = 1
    var inString = false
    var escaped = false
    for (character in text) {
        if (inString) {
            if (character < ' ') throw unclosedIn(line)
            inString = escaped || character != '"'
            escaped = !escaped && character == '\\'
        } else {
            when (character) {
                '\n' -> line++
                '"' -> inString = true
                '{', '[' -> depth++
                '}', ']' -> depth--
            }
        }
        if (depth > JsonLimits.MAXIMUM_DEPTH) throw tooDeepIn(line)
    }
    if (inString) throw unclosedIn(line)
}

private fun unclosedIn(line: Int) = LimitExceeded(told { textNotClosed(line) }, line)

private fun tooDeepIn(line: Int) = LimitExceeded(told { bracketsTooDeep(line) }, line)

/** The line, from 1, that the character at [offset] is in. */
internal fun lineAt(text: String, offset: Int): Int = 1 + (0..<minOf(offset, text.length)).count { text[it] == '\n' }
