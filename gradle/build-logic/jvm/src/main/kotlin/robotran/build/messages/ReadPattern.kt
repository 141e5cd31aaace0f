package robotran.build.messages

/**
 * Reads the [text] of a sentence in the syntax of ICU's MessageFormat: `{name}`, `{name, number}`,
 * `{count, plural, one {..} other {# ..}}`, `{kind, select, RED {..} other {..}}`. As in ICU, two apostrophes are one,
 * and one before a brace or a number sign quotes up to the next. Beyond ICU: an argument may be a property
 * (`who.name`) or a message of the table (`thing(who)`), several keys of an arm stand between bars, and
 * `{names, list, and}` joins a list.
 *
 * @throws CatalogueException if it is not well-formed.
 */
fun readPattern(text: String): Pattern = PatternReader(text).read()

private class PatternReader(private val text: String) {
    private var position = 0

    fun read(): Pattern = pattern(isInPlural = false, isNested = false)

    private fun pattern(isInPlural: Boolean, isNested: Boolean): Pattern {
        val parts = mutableListOf<PatternPart>()
        val plain = StringBuilder()

        fun endText() {
            if (plain.isNotEmpty()) parts += PatternPart.Text(plain.toString())
            plain.clear()
        }
        while (position < text.length && text[position] != '}') {
            when (val character = text[position]) {
                '{' -> {
                    endText()
                    parts += argument(isInPlural)
                }

                '#' -> if (isInPlural) {
                    endText()
                    parts += PatternPart.CountedNumber
                    position++
                } else {
                    plain.append(character)
                    position++
                }

                '\'' -> apostrophe(plain)
                else -> {
                    plain.append(character)
                    position++
                }
            }
        }
        if (!isNested && position < text.length) fail("a brace closes that was not opened")
        endText()
        return Pattern(parts)
    }

    private fun apostrophe(plain: StringBuilder) {
        val next = text.getOrNull(position + 1)
        when (next) {
            '\'' -> {
                plain.append('\'')
                position += 2
            }

            '{', '}', '#' -> {
                val end = text.indexOf('\'', position + 1)
                if (end < 0) fail("an apostrophe quotes to the end")
                plain.append(text, position + 1, end)
                position = end + 1
            }

            else -> {
                plain.append('\'')
                position++
            }
        }
    }

    private fun argument(isInPlural: Boolean): PatternPart {
        position++
        val expression = until(",}").trim()
        if (expression.isEmpty()) fail("a placeholder has no name")
        if (text[position] == '}') return PatternPart.Placeholder(expression).also { position++ }
        position++
        val format = until(",}").trim()
        ValueFormat.entries.find { it.keyword == format }?.let {
            close()
            return PatternPart.Formatted(expression, it)
        }
        if (text[position] != ',') fail("\"$format\" needs more")
        position++
        if (format == LIST) {
            val word = until("}").trim()
            close()
            return PatternPart.Listed(expression, word)
        }
        val kind = ChoiceKind.entries.find { it.keyword == format } ?: fail("there is no format \"$format\"")
        return PatternPart.Choice(expression, kind, arms(isInPlural || kind == ChoiceKind.PLURAL))
    }

    private fun arms(isInPlural: Boolean): List<Arm> {
        val arms = mutableListOf<Arm>()
        while (true) {
            skipBlanks()
            if (position >= text.length) fail("a choice does not end")
            if (text[position] == '}') break
            val keys = until("{").split('|').map { it.trim() }
            position++
            arms += Arm(keys, pattern(isInPlural, isNested = true))
            close()
        }
        position++
        if (arms.isEmpty()) fail("a choice has no arms")
        return arms
    }

    /** The text up to one of [ends], outside brackets and quotation marks. */
    private fun until(ends: String): String {
        val start = position
        var depth = 0
        var isQuoted = false
        while (position < text.length) {
            val character = text[position]
            when {
                character == '"' -> isQuoted = !isQuoted
                isQuoted -> Unit
                depth == 0 && character in ends -> return text.substring(start, position)
                character in "({" -> depth++
                character in ")}" -> depth--
            }
            position++
        }
        fail("a brace is not closed")
    }

    private fun close() {
        if (text.getOrNull(position) != '}') fail("a brace is not closed")
        position++
    }

    private fun skipBlanks() {
        while (position < text.length && text[position] == ' ') position++
    }

    private fun fail(why: String): Nothing = throw CatalogueException("$why: \"$text\"")
}

private const val LIST = "list"
