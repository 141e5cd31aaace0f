package robotran.json

import robotran.json.messages.reason
import robotran.language.Language

/** A text is no JSON, or exceeds a limit, so that it must not be parsed. */
internal class JsonSyntaxException(val sentence: (Language) -> String, val line: Int?) :
    Exception(sentence(Language.ENGLISH))

/**
 * Checks that a text is JSON within the [JsonLimits], and tells the first mistake in words of what people write: the
 * parser's own messages name an offset and what it expects. Takes time in proportion to the text.
 */
internal class JsonSyntax(private val text: String) {
    private val reader = JsonTokens(text)
    private val steps = mutableListOf<JsonStep>()
    private val doubled = mutableListOf<JsonPath>()

    /** The members whose names an object has twice, at most [JsonLimits.MAXIMUM_WARNINGS]. */
    fun check(): List<JsonPath> {
        if (text.length > JsonLimits.MAXIMUM_CHARACTERS) {
            throw JsonSyntaxException(reason { fileTooLong(JsonLimits.MAXIMUM_CHARACTERS) }, null)
        }
        reader.skipBlanks()
        if (reader.isAtEnd) throw JsonSyntaxException(reason { emptyFile() }, null)
        if (reader.startsWord && !reader.startsLiteral) reader.fail { mustBeginWithBrace(it) }
        value(depth = 0, member = null)
        reader.skipBlanks()
        when (val rest = reader.next) {
            null -> return doubled
            '}', ']' -> reader.fail { tooManyBrackets(it, "$rest") }
            else -> reader.fail { goesOn(it) }
        }
    }

    /** @param member the name of the member whose value this is; null for an item. */
    private fun value(depth: Int, member: String?) {
        val next = reader.next
        when {
            next == '"' -> reader.string()
            next == '{' -> members(depth + 1)
            next == '[' -> items(depth + 1)
            reader.startsNumber -> reader.number()
            reader.startsWord -> reader.word()
            member != null && (next == null || next in ",}]") -> reader.fail { missingValue(it, member) }
            next == ',' -> reader.fail { extraComma(it) }
            else -> reader.failAtSign()
        }
    }

    private fun members(depth: Int) {
        val names = mutableSetOf<String>()
        entries(depth, '}') {
            if (reader.next != '"') reader.failAtName()
            val line = reader.line
            val name = reader.string()
            steps += JsonStep.Member(name)
            if (!names.add(name) && doubled.size < JsonLimits.MAXIMUM_WARNINGS) doubled += JsonPath.of(steps)
            reader.skipBlanks()
            when (reader.next) {
                ':' -> reader.skip()
                '=' -> reader.fail { writeInstead(it, "=", ":") }
                else -> reader.fail(line) { missingColon(it, name) }
            }
            reader.skipBlanks()
            value(depth, name)
            reader.checkDecimalComma()
            steps.removeLast()
        }
    }

    private fun items(depth: Int) {
        var count = 0
        entries(depth, ']') {
            steps += JsonStep.Item(count++)
            value(depth, null)
            steps.removeLast()
        }
    }

    /** What is between brackets, the first of which is next. */
    private fun entries(depth: Int, closing: Char, entry: () -> Unit) {
        val opening = JsonBracket(checkNotNull(reader.next), closing, reader.line)
        if (depth > JsonLimits.MAXIMUM_DEPTH) reader.fail { bracketsTooDeep(it) }
        reader.skip()
        reader.skipBlanks()
        if (reader.next == closing) return reader.skip()
        while (true) {
            if (reader.isAtEnd) reader.failOpen(opening)
            entry()
            val end = reader.mark()
            reader.skipBlanks()
            when (reader.next) {
                closing -> return reader.skip()
                ',' -> Unit
                else -> reader.failAfterEntry(end, opening)
            }
            val comma = reader.line
            reader.skip()
            reader.skipBlanks()
            if (reader.next == closing) reader.fail(comma) { lastComma(it) }
        }
    }
}

/** A bracket that was opened in [line]. */
internal class JsonBracket(val opening: Char, val closing: Char, val line: Int)
