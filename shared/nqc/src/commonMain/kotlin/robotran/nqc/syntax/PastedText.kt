package robotran.nqc.syntax

import robotran.language.pasted.PastedCharacter
import robotran.language.pasted.pastedCharacter
import robotran.language.pasted.plainTextOf
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode

/** The characters of [text] that come into programs by pasting only, and what they stand for. */
internal class PastedText(private val text: String, private val sink: DiagnosticSink) {
    private fun at(index: Int): PastedCharacter? = text.getOrNull(index)?.let(::pastedCharacter)

    /** Whether here is a blank, or nothing that can be seen. */
    fun isUnseen(index: Int): Boolean = at(index)?.isUnseen == true

    fun isVisible(index: Int): Boolean = at(index)?.isUnseen == false

    /** What the character at [index] stands for, at least its first sign. */
    fun plainAt(index: Int): Char = at(index)?.plain?.firstOrNull() ?: text[index]

    fun isNameStart(index: Int): Boolean = isVisible(index) && isNameStart(plainAt(index))

    /** Whether the character at [index] may be in a name: a letter, or one that cannot be seen. */
    fun isInName(index: Int): Boolean = at(index)?.let { it.plain.isEmpty() || isNamePart(it.plain.first()) } == true

    fun endOfDigits(start: Int): Int {
        var end = start
        while (end < text.length && isDigit(plainAt(end))) end++
        return end
    }

    /** How many characters from [start] on are the longest sign. */
    fun lengthOfSign(start: Int): Int {
        val longest = (1..LONGEST_SIGN).takeWhile { isVisible(start + it - 1) }.lastOrNull() ?: 1
        return (longest downTo 1).firstOrNull { length ->
            val plain = plainTextOf(text.substring(start, start + length))
            Signs.lengthAt(plain, 0) == plain.length
        } ?: 1
    }

    fun isQuote(index: Int): Boolean = text[index] == QUOTE || (isVisible(index) && plainAt(index) in QUOTES)

    /** The end of the text in quotation marks of any kind that begins at [start]; 0 if none begins there. */
    fun endOfQuote(start: Int): Int {
        if (!isQuote(start)) return 0
        var end = start + 1
        while (end < text.length && !isLineEnd(text[end]) && !closes(text[start], end)) end++
        val isClosed = end < text.length && closes(text[start], end)
        // A pasted mark alone is only a mark.
        return if (isClosed) {
            end + 1
        } else if (text[start] == QUOTE) {
            end
        } else {
            0
        }
    }

    private fun closes(opening: Char, index: Int) = if (opening == QUOTE) text[index] == QUOTE else isQuote(index)

    /** [quote] with the quotation marks of the language around it. */
    fun quoted(quote: String): String = QUOTE + quote.substring(1, quote.length - 1) + QUOTE

    /** Reports what was pasted between [start] and [end] of a line. Its fix mends the rest of the line, too. */
    fun report(start: Int, end: Int, range: SourceRange) {
        if (!sink.takesErrorAt(range)) return
        val first = (start until end).firstOrNull { at(it) != null } ?: start
        val last = if (isQuote(first)) end else endOfPasted(first, end)
        val written = text.substring(first, if (isQuote(first)) first + 1 else end)
        val plain = text.substring(first, last).let { if (isQuote(first)) quoted(it) else plainTextOf(it) }
        val place = range.copy(column = range.column + first - start, endColumn = range.column + last - start)
        val message = sink.messages.pastedCharacter(at(first) ?: return, written)
        sink.report(NqcDiagnosticCode.UNKNOWN_CHARACTER, range, message, SourceFix(place, plain))
    }

    /** Behind the last pasted character of the line that is in no comment and no text. */
    private fun endOfPasted(start: Int, least: Int): Int {
        var last = least
        var index = least
        while (index < text.length && !isLineEnd(text[index]) && !isQuote(index) && !isComment(index)) {
            if (at(index++) != null) last = index
        }
        return if (at(start) == null) least else last
    }

    private fun isComment(index: Int) = text.startsWith("//", index) || text.startsWith("/*", index)

    private companion object {
        const val QUOTE = '"'
        const val QUOTES = "\"'"
        const val LONGEST_SIGN = 3
    }
}
