package robotran.robolang.outline

import robotran.language.source.SourceRange
import robotran.language.source.SourceSpan
import robotran.robolang.syntax.BYTE_ORDER_MARK
import robotran.robolang.syntax.ScannedLine

/** Converts lines and columns of [source], which was scanned to [lines], to offsets. */
internal class LineOffsets(private val source: String, private val lines: List<ScannedLine>) {
    private val starts = IntArray(lines.size)

    init {
        var start = if (source.startsWith(BYTE_ORDER_MARK)) BYTE_ORDER_MARK.length else 0
        lines.forEachIndexed { index, line ->
            starts[index] = start
            start += line.text.length
            start += breakAt(start)
        }
    }

    /** The span of the line [index] from 0, without its line break. */
    fun line(index: Int): SourceSpan = SourceSpan(starts[index], starts[index] + lines[index].text.length)

    /** The offset behind the line break of the line [index]. */
    fun end(index: Int): Int = line(index).end.let { it + breakAt(it) }

    fun span(range: SourceRange): SourceSpan {
        val start = starts[range.line - 1] - 1
        return SourceSpan(start + range.column, start + range.endColumn)
    }

    /** The width of the line break at [offset]. */
    private fun breakAt(offset: Int): Int = when {
        offset >= source.length -> 0
        source.startsWith("\r\n", offset) -> 2
        else -> 1
    }
}
