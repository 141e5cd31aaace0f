package robotran.textediting

import robotran.languagesupport.CodeSyntax
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection

/** The lines of the selection, without the last line if the selection ends at its start. */
private fun TextDocument.selectedLines(): IntRange {
    val first = lines.lineOf(selection.start)
    val last = lines.lineOf(selection.end)
    return if (last > first && selection.end == lines.start(last)) first..<last else first..last
}

/** This text with [change] applied to every selected line. The selection moves with its characters. */
private fun TextDocument.withSelectedLines(change: (String) -> String): TextDocument {
    val chosen = selectedLines()
    val from = lines.start(chosen.first)
    val until = lines.end(chosen.last)
    val before = chosen.map(lines::line)
    val after = before.map(change)
    val text = text.replaceRange(from, until, after.joinToString("\n"))
    val moved = { offset: Int ->
        val line = lines.lineOf(offset)
        val index = line - chosen.first
        when {
            line < chosen.first -> offset
            line > chosen.last -> offset + text.length - this.text.length

            else -> from + after.take(index).sumOf { it.length + 1 } +
                (after[index].length - (before[index].length - lines.columnOf(offset))).coerceIn(0, after[index].length)
        }
    }
    return TextDocument(text, TextSelection(moved(selection.anchor), moved(selection.caret)))
}

/** This text with the selected lines indented by one level. */
fun TextDocument.indented(syntax: CodeSyntax): TextDocument = withSelectedLines {
    if (it.isBlank()) {
        it
    } else {
        syntax.indent + it
    }
}

/** This text with the selected lines unindented by one level. */
fun TextDocument.unindented(syntax: CodeSyntax): TextDocument =
    withSelectedLines { it.drop(minOf(syntax.indent.length, indentOf(it).length)) }

/** This text with the selected lines commented out or, if they all are already, uncommented. */
fun TextDocument.withCommentToggled(syntax: CodeSyntax): TextDocument {
    val mark = syntax.commentMark
    val written = selectedLines().map(lines::line).filter { it.isNotBlank() }
    if (written.isEmpty()) return this
    if (written.all { it.trimStart().startsWith(mark) }) {
        return withSelectedLines { indentOf(it) + it.trimStart().removePrefix(mark).removePrefix(" ") }
    }
    val indent = written.minOf { indentOf(it).length }
    return withSelectedLines { if (it.isBlank()) it else it.take(indent) + mark + " " + it.drop(indent) }
}

/** This text with the selected lines moved above the line before them. */
fun TextDocument.withLinesMovedUp(): TextDocument {
    val chosen = selectedLines()
    if (chosen.first == 0) return this
    val above = lines.line(chosen.first - 1)
    val moved = text.substring(lines.start(chosen.first), lines.end(chosen.last))
    val text = text.replaceRange(lines.start(chosen.first - 1), lines.end(chosen.last), moved + "\n" + above)
    return TextDocument(text, selection.shifted(-(above.length + 1)).within(text.length))
}

/** This text with the selected lines moved below the line after them. */
fun TextDocument.withLinesMovedDown(): TextDocument {
    val chosen = selectedLines()
    if (chosen.last == lines.count - 1) return this
    val below = lines.line(chosen.last + 1)
    val moved = text.substring(lines.start(chosen.first), lines.end(chosen.last))
    val text = text.replaceRange(lines.start(chosen.first), lines.end(chosen.last + 1), below + "\n" + moved)
    return TextDocument(text, selection.shifted(below.length + 1).within(text.length))
}

/** This text with a copy of the selected lines below them. */
fun TextDocument.withLinesDuplicated(): TextDocument {
    val chosen = selectedLines()
    val copied = text.substring(lines.start(chosen.first), lines.end(chosen.last))
    val end = lines.end(chosen.last)
    return TextDocument(text.replaceRange(end, end, "\n" + copied), selection.shifted(copied.length + 1))
}

fun TextDocument.withoutLines(): TextDocument {
    val chosen = selectedLines()
    val isLast = chosen.last == lines.count - 1
    val from = if (isLast && chosen.first > 0) lines.end(chosen.first - 1) else lines.start(chosen.first)
    val until = if (isLast) text.length else lines.start(chosen.last + 1)
    val column = lines.columnOf(selection.caret)
    val shorter = TextDocument(text.removeRange(from, until))
    return shorter.withCaret(shorter.lines.offset(minOf(chosen.first, shorter.lines.count - 1), column))
}

private fun TextSelection.shifted(by: Int) = TextSelection(anchor + by, caret + by)
