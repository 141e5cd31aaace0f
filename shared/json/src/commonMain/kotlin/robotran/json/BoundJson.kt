package robotran.json

import robotran.json.messages.told
import robotran.language.Language

/** A limit is exceeded, so the file must not be parsed. */
internal class LimitExceeded(val sentence: (Language) -> String, val line: Int?) : Exception(sentence(Language.ENGLISH))

/**
 * Rejects a text that is too long, nested too deep, or has a string that continues beyond its line. The latter is
 * nearly always a forgotten quote, which the parser would only report much further down.
 */
internal fun checkJsonLimits(text: String) {
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

/** The line, from 1, of the character at [offset]. */
internal fun lineAt(text: String, offset: Int): Int = 1 + (0..<minOf(offset, text.length)).count { text[it] == '\n' }
