package robotran.programs

import robotran.language.source.SourceFix

/** This source after [fix]; unchanged if its range does not exist. */
fun String.withFix(fix: SourceFix): String {
    val from = offsetOf(fix.range.line, fix.range.column) ?: return this
    val to = offsetOf(fix.range.line, fix.range.endColumn) ?: return this
    return if (from <= to) replaceRange(from, to, fix.replacement) else this
}

/** The offset of [column] in [line], both from 1; null if out of range. The column after the end is valid. */
private fun String.offsetOf(line: Int, column: Int): Int? {
    var start = 0
    repeat(line - 1) {
        val end = indexOf('\n', start)
        if (end < 0) return null
        start = end + 1
    }
    val end = indexOf('\n', start).let { if (it < 0) length else it }
    return (start + column - 1).takeIf { it in start..end }
}

/** This program after [fix] of [file]; null if it has no such file, or cannot be changed. */
fun ProgramSource.withFix(file: String, fix: SourceFix): ProgramSource? {
    val language = language ?: return null
    if (files.none { it.name == file }) return null
    // Columns do not count a byte order mark.
    val fixed = files.map { if (it.name == file) it.copy(text = it.text.removePrefix("\uFEFF").withFix(fix)) else it }
    return Program(name, language, fixed)
}
