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
    val unclosedTexts: List<Int> get() = unclosed

    init {
        while (code.length < source.length) readNext()
        text = code.toString()
    }

    private fun readNext() {
        val place = code.length
        when {
            source.startsWith("//", place) -> blank(endOfLine(place))
            source.startsWith("/*", place) -> blank(endOfComment(place))
            source[place] == '"' || source[place] == '\'' -> readQuoted(source[place])
            else -> code.append(source[place])
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

    private fun endOfLine(place: Int) = source.indexOfAny(LINE_ENDS, place).let { if (it < 0) source.length else it }

    private fun endOfComment(place: Int) = source.indexOf("*/", place + 2).let { if (it < 0) source.length else it + 2 }

    private companion object {
        val LINE_ENDS = charArrayOf('\n', '\r')
    }
}
