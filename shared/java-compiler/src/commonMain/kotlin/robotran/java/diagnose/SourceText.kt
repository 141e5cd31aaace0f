package robotran.java.diagnose

import robotran.java.JavaFix
import robotran.java.JavaRange
import robotran.java.JavaSource

/** A source with its lines; `\n`, `\r\n` and `\r` end a line. */
internal class SourceText(source: JavaSource) {
    val path = source.path
    private val text = source.text
    private val lineStarts: List<Int> = listOf(0) + text.indices.filter(::endsLine).map { it + 1 }

    /** From [start] to before [end], but not beyond the end of the line. */
    fun range(start: Int, end: Int): JavaRange {
        val from = start.coerceIn(0, text.length)
        val found = lineStarts.binarySearch(from)
        val line = if (found >= 0) found else -found - 2
        val until = end.coerceIn(from, lineEnd(from))
        return JavaRange(line + 1, from - lineStarts[line] + 1, until - lineStarts[line] + 1)
    }

    /** What stands there, up to the end of the line. */
    fun words(start: Int, end: Int): String {
        val from = start.coerceIn(0, text.length)
        return text.substring(from, end.coerceIn(from, lineEnd(from)))
    }

    /** The name before the point before [place], null if there is none. */
    fun qualifier(place: Int): String? {
        if (text.getOrNull(place - 1) != '.') return null
        return text.substring(0, place - 1).takeLastWhile { it.isLetterOrDigit() || it == '_' }.ifEmpty { null }
    }

    /** All names of the source, each once, in their order. */
    val names: List<String> by lazy { NAME.findAll(text).map { it.value }.distinct().toList() }

    /** Puts [line] where imports stand. */
    fun addLineAtTop(line: String): JavaFix {
        val place = PACKAGE.find(text)?.range?.last?.plus(1) ?: 0
        return JavaFix(range(place, place), if (place == 0) "$line\n" else "\n$line")
    }

    private fun endsLine(place: Int) = text[place] == '\n' || (text[place] == '\r' && text.getOrNull(place + 1) != '\n')

    private fun lineEnd(place: Int): Int {
        val end = text.indexOfAny(charArrayOf('\n', '\r'), place)
        return if (end < 0) text.length else end
    }

    private companion object {
        val NAME = Regex("[A-Za-z_][A-Za-z_0-9]*")
        val PACKAGE = Regex("""^\s*package\s+[\w.]+\s*;""")
    }
}
