package robotran.workshop.state

import robotran.robolang.diagnostic.SourceFix

/** This text with every line end written as the editor writes it. */
fun String.withPlainLineEnds(): String = if ('\r' in this) replace("\r\n", "\n").replace('\r', '\n') else this

/** This source after [fix]; unchanged if the place it names does not exist. */
fun String.mendedBy(fix: SourceFix): String {
    val from = offsetOf(fix.range.line, fix.range.column) ?: return this
    val to = offsetOf(fix.range.line, fix.range.endColumn) ?: return this
    return if (from <= to) replaceRange(from, to, fix.replacement) else this
}

/**
 * Where [column] of [line] is, both from 1; the column after the last character counts. Null if there is no such place.
 */
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
