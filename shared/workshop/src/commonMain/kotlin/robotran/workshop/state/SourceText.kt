package robotran.workshop.state

import robotran.robolang.diagnostic.SourceFix

/** This text with the editor's line ends. */
fun String.withPlainLineEnds(): String = if ('\r' in this) replace("\r\n", "\n").replace('\r', '\n') else this

/** This source after [fix]; unchanged if its range does not exist. */
fun String.withFix(fix: SourceFix): String {
    val from = offsetOf(fix.range.line, fix.range.column) ?: return this
    val to = offsetOf(fix.range.line, fix.range.endColumn) ?: return this
    return if (from <= to) replaceRange(from, to, fix.replacement) else this
}

/** The offset of [column] in [line], both from 1; null if out of range. The column after the end is valid. */
fun String.offsetOf(line: Int, column: Int): Int? {
    var start = 0
    repeat(line - 1) {
        val end = indexOf('\n', start)
        if (end < 0) return null
        start = end + 1
    }
    val end = indexOf('\n', start).let { if (it < 0) length else it }
    return (start + column - 1).takeIf { it in start..end }
}
