package robotran.javacompiler.diagnose

import robotran.javacompiler.ecj.JavaSource

/** A source with its lines, which end in `\n`, `\r\n` or `\r`. */
internal class SourceText(source: JavaSource) {
    val path = source.path
    private val text = source.text
    private val lineStarts: List<Int> = listOf(0) + text.indices.filter(::endsLine).map { it + 1 }

    /** The source without comments and the contents of literals. */
    val code: CodeOnly by lazy { CodeOnly(text) }

    /** The range from [start] to before [end], but not beyond the end of the line. */
    fun range(start: Int, end: Int): JavaRange {
        val from = start.coerceIn(0, text.length)
        val line = lineOf(from)
        val until = end.coerceIn(from, lineEnd(from))
        return JavaRange(line + 1, from - lineStarts[line] + 1, until - lineStarts[line] + 1)
    }

    fun range(place: SourceSpan) = range(place.start, place.end)

    /** A fix that inserts [words] at [place]. */
    fun insertion(place: Int, words: String) = JavaFix(range(place, place), words)

    /** The text from [start] to before [end], but not beyond the end of the line. */
    fun words(start: Int, end: Int): String {
        val from = start.coerceIn(0, text.length)
        return text.substring(from, end.coerceIn(from, lineEnd(from)))
    }

    /** The text from [start] to before the character [end], or to the end of the line. */
    fun wordsUntil(start: Int, end: Char): String = words(start, text.length).substringBefore(end)

    /** The name before the dot at the end of which [place] is; null if there is none. */
    fun qualifier(place: Int): String? {
        if (text.getOrNull(place - 1) != '.') return null
        return text.substring(0, place - 1).takeLastWhile { it.isLetterOrDigit() || it == '_' }.ifEmpty { null }
    }

    /** All distinct names of the source, in order of appearance. */
    val names: List<String> by lazy { NAME.findAll(text).map { it.value }.distinct().toList() }

    /** The last non-blank character of the code before [place]; null if there is none. */
    fun codeBefore(place: Int): Char? {
        var last = place.coerceAtMost(text.length) - 1
        while (last >= 0 && code.text[last].isWhitespace()) last--
        return code.text.getOrNull(last)
    }

    /** The offset of the first non-blank character of the code from [place] on, or the end of the source. */
    fun codeFrom(place: Int): Int {
        var next = place.coerceIn(0, text.length)
        while (next < text.length && code.text[next].isWhitespace()) next++
        return next
    }

    /** The code of the line before [place]. */
    fun lineBefore(place: Int): String = code.text.substring(lineStarts[lineOf(place)], place)

    fun codeAt(place: Int): Char? = code.text.getOrNull(place)

    /** The number of open braces before [place]. */
    fun bracesBefore(place: Int): Int {
        val before = code.text.substring(0, place.coerceIn(0, text.length))
        return before.count { it == '{' } - before.count { it == '}' }
    }

    /** The offset of a string on the line of [place] that does not end there; null if there is none. */
    fun unclosedText(place: Int): Int? {
        val line = lineOf(place.coerceIn(0, text.length))
        return code.unclosedTexts.firstOrNull { lineOf(it) == line }
    }

    /** A fix that inserts [line] where imports belong. */
    fun addLineAtTop(line: String): JavaFix {
        val place = PACKAGE.find(code.text)?.range?.last?.plus(1) ?: 0
        return insertion(place, if (place == 0) "$line\n" else "\n$line")
    }

    /** The index of the line, from 0. */
    private fun lineOf(place: Int): Int = lineStarts.binarySearch(place).let { if (it >= 0) it else -it - 2 }

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
