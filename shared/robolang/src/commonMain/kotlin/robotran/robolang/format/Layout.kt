package robotran.robolang.format

import robotran.robolang.syntax.ParsedProgram
import robotran.robolang.syntax.ScannedLine
import robotran.robolang.words.Keyword
import robotran.robolang.words.OPENERS

private const val INDENTATION = "  "

/** The min distance between a line and its comment; the longest of neighbouring lines has exactly this. */
private const val SPACES_BEFORE_COMMENT = 2

/** A formatted line without its comment. */
private class FormattedLine(val code: String, val indentation: String, val comment: String?) {
    val isEmpty: Boolean get() = code.isEmpty() && comment == null
    val hasBoth: Boolean get() = code.isNotEmpty() && comment != null
}

/** Formats a program without syntax errors. */
internal fun layout(parsed: ParsedProgram): String {
    val lines = withoutNeedlessEmptyLines(laidLines(parsed))
    return buildString {
        var position = 0
        while (position < lines.size) {
            val run = lines.subList(position, lines.size).takeWhile { it.hasBoth }
            val width = run.maxOfOrNull { it.code.length } ?: 0
            val next = if (run.isEmpty()) lines.subList(position, position + 1) else run
            next.forEach { appendLine(it, width) }
            position += next.size
        }
    }
}

private fun laidLines(parsed: ParsedProgram): List<FormattedLine> {
    val line = LineLayout(parsed.names)
    var depth = 0
    return parsed.lines.map { scanned ->
        val first = scanned.tokens.firstOrNull()?.takeUnless { line.isName(it) }?.keyword
        val closes = first == Keyword.END || first == Keyword.ELSE
        val opens = first == Keyword.ELSE || first in OPENERS
        if (closes) depth--
        laidLine(scanned, line, depth).also { if (opens) depth++ }
    }
}

private fun laidLine(scanned: ScannedLine, line: LineLayout, depth: Int): FormattedLine {
    val indentation = INDENTATION.repeat(depth)
    val code = if (scanned.tokens.isEmpty()) "" else indentation + line.textOf(scanned.tokens)
    return FormattedLine(code, indentation, scanned.comment?.text)
}

/** Drops repeated empty lines, and those at the beginning and the end. */
private fun withoutNeedlessEmptyLines(lines: List<FormattedLine>): List<FormattedLine> {
    val kept = mutableListOf<FormattedLine>()
    for (line in lines) {
        if (!line.isEmpty || kept.lastOrNull()?.isEmpty == false) kept += line
    }
    if (kept.lastOrNull()?.isEmpty == true) kept.removeAt(kept.lastIndex)
    return kept
}

private fun StringBuilder.appendLine(line: FormattedLine, width: Int) {
    append(line.code)
    if (line.comment != null) {
        if (line.hasBoth) {
            append(" ".repeat(width - line.code.length + SPACES_BEFORE_COMMENT))
        } else {
            append(line.indentation)
        }
        append(line.comment)
    }
    append('\n')
}
