package robotran.javacompiler.diagnose

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.language.source.SourceSpan
import robotran.languagesupport.SourceFile

/**
 * A source with its lines, which end in `\n`, `\r\n` or `\r`. Offsets may lie outside: ECJ reports some
 * problems before the start of the source.
 */
internal class SourceText(source: SourceFile) {
    val path = source.name
    private val text = source.text

    /** The name that the file gives its public class. */
    val className: String get() = path.substringAfterLast('/').removeSuffix(".java")

    private val lineStarts: List<Int> = listOf(0) + text.indices.filter(::endsLine).map { it + 1 }

    /** The source without comments and the contents of literals. */
    val code: CodeOnly by lazy { CodeOnly(text) }

    /** The range from [start] to before [end], but not beyond the end of the line. */
    fun range(start: Int, end: Int): SourceRange {
        val from = start.coerceIn(0, text.length)
        val line = lineOf(from)
        val until = end.coerceIn(from, lineEnd(from))
        return SourceRange(line + 1, from - lineStarts[line] + 1, until - lineStarts[line] + 1)
    }

    fun range(offset: SourceSpan) = range(offset.start, offset.end)

    /** A fix that inserts [words] at [offset]. */
    fun insertion(offset: Int, words: String) = SourceFix(range(offset, offset), words)

    /** The text from [start] to before [end], but not beyond the end of the line. */
    fun words(start: Int, end: Int): String {
        val from = start.coerceIn(0, text.length)
        return text.substring(from, end.coerceIn(from, lineEnd(from)))
    }

    /** The text from [start] to before the character [end], or to the end of the line. */
    fun snippetUntil(start: Int, end: Char): String = words(start, text.length).substringBefore(end)

    /** The name before the dot at the end of which [offset] is; null if there is none. */
    fun qualifier(offset: Int): String? {
        if (text.getOrNull(offset - 1) != '.') return null
        return text.substring(0, offset - 1).takeLastWhile { it.isLetterOrDigit() || it == '_' }.ifEmpty { null }
    }

    /** All distinct names of the source, in order of appearance. */
    val names: List<String> by lazy { NAME.findAll(text).map { it.value }.distinct().toList() }

    /** The last non-blank character of the code before [offset]; null if there is none. */
    fun codeBefore(offset: Int): Char? {
        var last = offset.coerceAtMost(text.length) - 1
        while (last >= 0 && code.text[last].isWhitespace()) last--
        return code.text.getOrNull(last)
    }

    /** The offset of the first non-blank character of the code from [offset] on, or the end of the source. */
    fun codeFrom(offset: Int): Int {
        var next = offset.coerceIn(0, text.length)
        while (next < text.length && code.text[next].isWhitespace()) next++
        return next
    }

    /** The code of the line of [offset] from there on. */
    fun codeBehind(offset: Int): String {
        val from = offset.coerceIn(0, text.length)
        return code.text.substring(from, lineEnd(from))
    }

    /** The code of the line before [offset]. */
    fun lineBefore(offset: Int): String {
        val until = offset.coerceIn(0, text.length)
        return code.text.substring(lineStarts[lineOf(until)], until)
    }

    fun codeAt(offset: Int): Char? = code.text.getOrNull(offset)

    /** The number of open braces before [offset]. */
    fun bracesBefore(offset: Int): Int {
        val before = code.text.substring(0, offset.coerceIn(0, text.length))
        return before.count { it == '{' } - before.count { it == '}' }
    }

    /** The offset of a string on the line of [offset] that does not end there; null if there is none. */
    fun unclosedString(offset: Int): Int? {
        val line = lineOf(offset.coerceIn(0, text.length))
        return code.unclosedStrings.firstOrNull { lineOf(it) == line }
    }

    /** Whether the class [name] of the package [home] is imported. */
    fun imports(name: String, home: String): Boolean =
        listOf("*", name).any { Regex("""\bimport\s+${Regex.escape("$home.$it")}\s*;""").containsMatchIn(code.text) }

    /** A fix that inserts [line] where imports belong. */
    fun addLineAtTop(line: String): SourceFix {
        val offset = PACKAGE.find(code.text)?.range?.last?.plus(1) ?: 0
        return insertion(offset, if (offset == 0) "$line\n" else "\n$line")
    }

    /** The index of the line, from 0. */
    private fun lineOf(offset: Int): Int = lineStarts.binarySearch(offset).let { if (it >= 0) it else -it - 2 }

    private fun endsLine(offset: Int) =
        text[offset] == '\n' || (text[offset] == '\r' && text.getOrNull(offset + 1) != '\n')

    private fun lineEnd(offset: Int): Int {
        val line = lineOf(offset)
        val next = lineStarts.getOrNull(line + 1) ?: return text.length
        return if (text[next - 1] == '\n' && text.getOrNull(next - 2) == '\r') next - 2 else next - 1
    }

    private companion object {
        val NAME = Regex("[A-Za-z_][A-Za-z_0-9]*")
        val PACKAGE = Regex("""^\s*package\s+[\w.]+\s*;""")
    }
}
