package robotran.json

import robotran.json.messages.JsonMessages
import robotran.json.messages.JsonSyntaxMessages
import robotran.json.messages.reason
import robotran.language.pasted.pastedCharacter

/** Reads the tokens of a JSON text, and knows what people write in their place. */
internal class JsonTokens(private val text: String) {
    private var place = 0

    /** The line of the next character, from 1. */
    var line = 1
        private set

    /** The last number that was read, without a blank behind it. */
    private var number = 0..<0

    val next: Char? get() = text.getOrNull(place)
    val isAtEnd: Boolean get() = place >= text.length
    val startsWord: Boolean get() = next?.let { it.isLetter() || it == '_' } == true
    val startsLiteral: Boolean get() = wordHere() in LITERALS
    val startsNumber: Boolean
        get() = next.isDigit() || (
            next?.let { it in "+-." } == true && text.getOrNull(place + 1)?.let {
                it.isAsciiDigit() || it == '.'
            } == true
        )

    fun skip() {
        place++
    }

    /** Where the last token has ended. */
    fun mark() = JsonMark(place, line)

    fun skipBlanks() {
        while (true) {
            when (next) {
                '\n' -> line++
                ' ', '\t', '\r' -> Unit
                '/' -> if (text.getOrNull(place + 1)?.let { it in "/*" } == true) fail { comment(it) } else return
                '#' -> fail { comment(it) }
                else -> return
            }
            place++
        }
    }

    /** Reads a text in quotes and returns what it says. */
    fun string(): String {
        val start = place++
        var isPlain = true
        while (true) {
            val character = next ?: fail { textNotClosed(it) }
            when {
                character == '"' -> break
                character == '\\' -> isPlain = false.also { escape() }
                character == '\t' -> fail { tabInText(it) }
                character == '\n' || character == '\r' -> fail { textNotClosed(it) }
                character < ' ' -> fail { invisibleInText(it) }
                else -> place++
            }
        }
        place++
        return if (isPlain) text.substring(start + 1, place - 1) else unquotedJson(text, start + 1, place - 1)
    }

    private fun escape() {
        val escaped = text.getOrNull(place + 1) ?: fail { textNotClosed(it) }
        val digits = if (escaped == 'u') UNICODE_DIGITS else 0
        val whole = text.substring(place, minOf(place + 2 + digits, text.length))
        val isRight = escaped in ESCAPED && whole.length == 2 + digits && whole.drop(2).all { it in HEXADECIMAL }
        if (!isRight) {
            val shown = whole.takeWhile { it >= ' ' && it != '"' }
            fail { noEscape(it, shown) }
        }
        place += whole.length
    }

    fun number() {
        val start = place
        while (next?.let { it.isAsciiLetterOrDigit() || it in "+-._" } == true) place++
        val written = text.substring(start, place)
        if (!isNumber(written)) {
            val right = repairedNumber(written)
            val shown = written.take(MAXIMUM_SHOWN)
            fail { if (right == null) noNumber(it, shown) else writeInstead(it, shown, right) }
        }
        number = start..<place
    }

    /** Fails if the number that was just read goes on with a comma, as in `32,5`. Not for lists, where that is right. */
    fun checkDecimalComma() {
        if (number.isEmpty() || place != number.last + 1 || next != ',' || !text.getOrNull(place + 1).isDigit()) return
        val digits = text.substring(place + 1).take(MAXIMUM_SHOWN).takeWhile { it.isAsciiDigit() }
        val whole = text.substring(number).take(MAXIMUM_SHOWN)
        fail { decimalComma(it, "$whole,$digits", "$whole.$digits") }
    }

    fun word() {
        val word = wordHere()
        place += word.length
        if (word in LITERALS) return
        val shown = word.take(MAXIMUM_SHOWN)
        val literal = LITERALS.find { it.equals(word, ignoreCase = true) } ?: OTHER_LITERALS[word.lowercase()]
        fail {
            when {
                word.lowercase() in NO_NUMBERS -> noNumber(it, shown)
                literal == null -> textNeedsQuotes(it, shown)
                else -> writeInstead(it, shown, literal)
            }
        }
    }

    /** Fails at what stands in place of the name of a member. */
    fun failAtName(): Nothing {
        val word = wordHere().take(MAXIMUM_SHOWN)
        if (word.isNotEmpty()) fail { nameNeedsQuotes(it, word) }
        if (next == ',') fail { extraComma(it) }
        failAtSign()
    }

    /** Fails at a sign that cannot stand where it is. */
    fun failAtSign(): Nothing {
        val sign = checkNotNull(next) { "The end of the text is told elsewhere." }
        val pasted = pastedCharacter(sign)
        when {
            sign in "'`" -> {
                val content = text.substring(place + 1).take(MAXIMUM_SHOWN).takeWhile { it != sign && it >= ' ' }
                fail { textNeedsQuotes(it, content) }
            }

            pasted != null && pasted.plain in QUOTES -> fail { curlyQuotes(it) }

            pasted != null -> {
                val line = line
                throw JsonSyntaxException({ JsonMessages.of(it).inLine(line, pasted.adviceIn(it)) }, line)
            }

            else -> {
                val shown = if (sign < ' ' || sign.isSurrogate()) "\\u" + hexadecimal(sign) else "$sign"
                fail { cannotStandThere(it, shown) }
            }
        }
    }

    /** Fails at what follows an entry that ended at [end], where neither a comma nor the end of the list follows. */
    fun failAfterEntry(end: JsonMark, opening: JsonBracket): Nothing {
        val sign = next ?: failOpen(opening)
        val follows = when (sign) {
            '"' -> text.substring(place).take(MAXIMUM_SHOWN).let { it.take(it.indexOf('"', 1) + 1).ifEmpty { "\"" } }
            else -> wordHere().ifEmpty { "$sign" }.take(MAXIMUM_SHOWN)
        }
        when {
            sign == '}' || sign == ']' -> fail {
                wrongBracket(it, "$sign", "${opening.opening}", opening.line, "${opening.closing}")
            }

            sign == ';' -> fail { writeInstead(it, ";", ",") }

            // A quote within a text ended it too early.
            startsWord && text[end.place - 1] == '"' && end.line == line -> fail { quoteInText(it) }
            !startsWord && !startsNumber && sign !in "\"{['" -> failAtSign()
            end.line == line -> fail { missingComma(it, follows) }
            else -> fail(end.line) { missingCommaAtEnd(it) }
        }
    }

    fun failOpen(bracket: JsonBracket): Nothing =
        fail(bracket.line) { bracketNotClosed(it, "${bracket.opening}", "${bracket.closing}") }

    /** Refuses the text for a mistake in [line]. */
    fun fail(line: Int = this.line, sentence: JsonSyntaxMessages.(line: Int) -> String): Nothing =
        throw JsonSyntaxException(reason { sentence(line) }, line)

    private fun wordHere(): String {
        var end = place
        while (end < text.length && (text[end].isLetterOrDigit() || text[end] in "_-$")) end++
        return text.substring(place, end)
    }

    private companion object {
        val LITERALS = listOf("true", "false", "null")

        /** What other languages call the same. */
        val OTHER_LITERALS = mapOf("none" to "null", "nil" to "null", "undefined" to "null")

        /** Numbers of other languages. */
        val NO_NUMBERS = listOf("nan", "infinity", "inf")
        const val ESCAPED = "\"\\/bfnrtu"
        const val HEXADECIMAL = "0123456789abcdefABCDEF"
        const val UNICODE_DIGITS = 4
        const val MAXIMUM_SHOWN = 30
        val QUOTES = listOf("\"", "'")
    }
}

/** A place between two tokens. */
internal class JsonMark(val place: Int, val line: Int)

/** [written] as JSON writes that number; null if it is none. */
private fun repairedNumber(written: String): String? {
    val sign = if (written.startsWith('-')) "-" else ""
    val size = written.trimStart('+', '-').trimEnd('.')
    val withZero = if (size.startsWith('.')) "0$size" else size
    val withoutZeros = withZero.trimStart('0').let { if (it.firstOrNull().isDigit()) it else "0$it" }
    return (sign + withoutZeros).takeIf(::isNumber)
}

private fun Char?.isDigit(): Boolean = this != null && isAsciiDigit()

private fun Char.isAsciiDigit(): Boolean = this in '0'..'9'

private fun Char.isAsciiLetterOrDigit(): Boolean = isAsciiDigit() || this in 'a'..'z' || this in 'A'..'Z'
