package robotran.blockediting

import robotran.language.source.SourceSpan
import robotran.robolang.outline.ProgramOutline
import robotran.robolang.outline.outlineRobolang
import robotran.robolang.syntax.RobolangLimits
import robotran.textediting.TextEdit
import robotran.textediting.editBetween

internal fun refused(reason: BlockEditError) = BlockEditResult.Failure(reason)

/**
 * The result of an edit that makes the lines of [program] the lines [rows].
 *
 * @param selected the rows to select, neighbours. Empty for a caret at the row [caret].
 */
internal fun resultOf(program: BlockProgram, rows: List<Row>, selected: List<Row>, caret: Int = 0): BlockEditResult {
    if (isTooDeep(rows)) return refused(BlockEditError.TooDeep)
    val unclosed = unclosed(rows)
    val near = unclosed.filter { block -> isNearChange(rows, block) }
    for (lacking in listOf(emptyList(), near, unclosed).distinct()) {
        val attempt = rows.closed(lacking, program)
        val text = RowText(program, attempt)
        if (text.text.length > RobolangLimits.SOURCE_CHARACTERS) return refused(BlockEditError.TooLong)
        val outline = outlineRobolang(text.text, program.messages, brick = program.brick)
        if (hasRows(outline, attempt)) return done(program, outline, text, attempt, selected, caret)
    }
    return refused(BlockEditError.LooseEnd)
}

private fun isNearChange(rows: List<Row>, block: IntRange): Boolean =
    (maxOf(block.first - 1, 0)..minOf(block.last, rows.size - 1)).any { rows[it].origin == null }

/** Whether [outline] has the blocks that [rows] are to be. */
private fun hasRows(outline: ProgramOutline, rows: List<Row>): Boolean {
    val last = outline.lines.last()
    val count = if (last.span.length == 0) outline.lines.size - 1 else outline.lines.size
    return count == rows.size && rows.indices.all {
        val line = outline.lines[it]
        line.depth == rows[it].depth && line.role == rows[it].role && line.span.length == rows[it].content.length
    }
}

private fun done(
    before: BlockProgram,
    outline: ProgramOutline,
    text: RowText,
    rows: List<Row>,
    selected: List<Row>,
    caret: Int,
): BlockEditResult {
    val program = blocksOf(outline, before.messages, before)
    val first = if (selected.isEmpty()) minOf(caret, rows.size) else rows.indexOfFirst { it === selected.first() }
    val last = if (selected.isEmpty()) first - 1 else rows.indexOfLast { it === selected.last() }
    val start = text.starts[first] + (rows.getOrNull(first)?.let { indentationOf(it.content).length } ?: 0)
    val end = if (last < first) start else text.starts[last] + rows[last].content.length
    return BlockEditResult.Success(
        program,
        text.changes(),
        editBetween(before.text, program.text),
        SourceSpan(start, end),
        blocksFrom(program, first, maxOf(first, last)),
    )
}

/** The blocks that begin at the line [first], or around it, up to the line [last]. */
private fun blocksFrom(program: BlockProgram, first: Int, last: Int): List<BlockId> = buildList {
    var line = first
    while (line <= last) {
        val block = program.blockOfLine(line) ?: break
        add(block.id)
        line = block.lines.last + 1
    }
}

/**
 * The result of [changes] of the text that do not overlap and are in order.
 *
 * @param selection what to select afterwards.
 */
internal fun resultOf(program: BlockProgram, changes: List<TextEdit>, selection: SourceSpan): BlockEditResult {
    val text = changed(program.text, changes)
    if (text.length > RobolangLimits.SOURCE_CHARACTERS) return refused(BlockEditError.TooLong)
    return doneWith(program, blocksOf(text, program.messages, program), changes, selection)
}

internal fun doneWith(
    before: BlockProgram,
    program: BlockProgram,
    changes: List<TextEdit>,
    selection: SourceSpan,
): BlockEditResult {
    val block = program.blockOfLine(program.lineAt(selection.start).index)
    val real = changes.mapNotNull { change ->
        editBetween(change.removed, change.inserted)?.let { it.copy(start = it.start + change.start) }
    }
    return BlockEditResult.Success(
        program,
        real,
        editBetween(before.text, program.text),
        selection,
        listOfNotNull(block?.id),
    )
}

/** [text] with [changes], whose offsets are those of [text]. */
internal fun changed(text: String, changes: List<TextEdit>): String = buildString(text.length) {
    var position = 0
    for (change in changes) {
        append(text, position, change.start).append(change.inserted)
        position = change.start + change.removed.length
    }
    append(text, position, text.length)
}
