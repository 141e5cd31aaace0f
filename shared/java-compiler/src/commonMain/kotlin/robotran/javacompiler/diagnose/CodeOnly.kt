package robotran.javacompiler.diagnose

/**
 * A source with its comments and the contents of its string and character literals replaced by spaces, so that the
 * offsets of the code stay the same.
 */
internal class CodeOnly(private val source: String) {
    private val code = StringBuilder(source.length)
    private val unclosed = mutableListOf<Int>()

    /** The blanked source, as long as the original. */
    val text: String

    /** The offsets of the double quotation marks that begin a string which does not end on its line. */
    val unclosedStrings: List<Int> get() = unclosed

    init {
        while (code.length < source.length) readNext()
        text = code.toString()
    }

    private fun readNext() {
        val offset = code.length
        when {
            source.startsWith("//", offset) -> blank(endOfLine(offset))
            source.startsWith("/*", offset) -> blank(endOfComment(offset))
            source[offset] == '"' || source[offset] == '\'' -> readQuoted(source[offset])
            else -> code.append(source[offset])
        }
    }

    private fun readQuoted(mark: Char) {
        val start = code.length
        val lineEnd = endOfLine(start)
        var end = start + 1
        while (end < lineEnd && source[end] != mark) end += if (source[end] == '\\') 2 else 1
        code.append(mark)
        if (end < lineEnd) {
            blank(end)
            code.append(mark)
        } else {
            if (mark == '"') unclosed += start
            blank(lineEnd)
        }
    }

    private fun blank(until: Int) {
        while (code.length < until) code.append(source[code.length].takeIf { it == '\n' || it == '\r' } ?: ' ')
    }

    private fun endOfLine(offset: Int) = source.indexOfAny(LINE_ENDS, offset).let { if (it < 0) source.length else it }

    private fun endOfComment(offset: Int) = source.indexOf("*/", offset + 2).let {
        if (it < 0) {
            source.length
        } else {
            it + 2
        }
    }

    private companion object {
        val LINE_ENDS = charArrayOf('\n', '\r')
    }
}
