package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.LineRole
import robotran.robolang.outline.OutlineLine
import robotran.textediting.TextEdit

/** Edits of one line as text. */
internal class LineEdits(private val program: BlockProgram) {
    fun setNote(edit: BlockEdit.SetNote): BlockEditResult {
        val line = line(edit.line) ?: return refused(BlockEditError.NotFound)
        val note = edit.note?.split("\r\n", "\n", "\r")?.joinToString(" ")?.trim()
        if (note == null && line.role == LineRole.COMMENT) {
            return RunEdits(program).delete(BlockEdit.Delete(setOf(checkNotNull(program.blockOfLine(line.index)).id)))
        }
        val content = line.span.textIn(program.text)
        val old = line.comment
        val words = old?.let { content.substring(0, it.start - line.span.start) } ?: content
        val start = line.span.start + words.trimEnd(::isIndentation).length
        val change = when {
            note == null -> if (old == null) null else change(start, old.end, "")
            old != null -> change(old.start, old.end, "// $note".trimEnd())
            line.role == LineRole.BLANK -> change(line.span.start, line.span.end, words + "// $note".trimEnd())
            else -> change(start, start, SPACE_BEFORE_NOTE + "// $note".trimEnd())
        }
        val caret = change?.let { it.start + it.inserted.length } ?: start
        val result = resultOf(program, listOfNotNull(change), SourceSpan(caret, caret))
        if (result !is BlockEditResult.Success || note == null) return result
        val written = result.program.outline.lines[line.index].comment?.textIn(result.program.text)
        return if (written == "// $note".trimEnd(::isIndentation)) result else refused(BlockEditError.NoNote)
    }

    fun replaceLine(edit: BlockEdit.ReplaceLine): BlockEditResult {
        val line = line(edit.line) ?: return refused(BlockEditError.NotFound)
        val content = line.span.textIn(program.text)
        val indentation = indentationOf(content)
        val lineBreak = lineBreakOf(program)
        val lines = edit.text.split("\r\n", "\n", "\r")
        val text = lines.mapIndexed { index, typed ->
            if (index == 0 ||
                typed.isEmpty()
            ) {
                typed
            } else {
                indentation + typed
            }
        }
        val start = line.span.start + indentation.length
        val change = change(start, line.span.end, text.joinToString(lineBreak))
        return resultOf(program, listOf(change), SourceSpan(start, start).ending(change))
    }

    fun applyFix(edit: BlockEdit.ApplyFix): BlockEditResult {
        val line = line(edit.line) ?: return refused(BlockEditError.NotFound)
        val fix = line.error?.fix ?: return refused(BlockEditError.NoFix)
        val fixed = program.outline.lines[fix.range.line - 1].span.start - 1
        val text = fix.replacement.replace("\n", lineBreakOf(program))
        val change = change(fixed + fix.range.column, fixed + fix.range.endColumn, text)
        return resultOf(program, listOf(change), SourceSpan(change.start, change.start).ending(change))
    }

    private fun SourceSpan.ending(change: TextEdit) = copy(end = change.start + change.inserted.length)

    private fun line(index: Int): OutlineLine? = program.outline.lines.getOrNull(index)?.takeIf {
        index < program.lineCount
    }

    private fun change(start: Int, end: Int, text: String) = TextEdit(start, program.text.substring(start, end), text)

    private companion object {
        /** The distance of a comment from its line, as the formatter writes it. */
        const val SPACE_BEFORE_NOTE = "  "
    }
}
