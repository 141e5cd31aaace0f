package robotran.blockediting

/** Edits that put whole blocks elsewhere. */
internal class RunEdits(private val program: BlockProgram) {
    private val rows = program.outline.rows(program.lineCount)

    fun insert(edit: BlockEdit.Insert): BlockEditResult {
        val line = program.lineIndexOf(edit.place) ?: return refused(BlockEditError.NotFound)
        val fragment = fragmentOf(program, edit.text)
        val lines = fragment.outline.rows(fragment.lineCount)
        if (lines.isEmpty()) return refused(BlockEditError.NothingToInsert)
        program.errorAt(edit.place, fragment.blocks)?.let { return refused(it) }
        val indentation = program.indentationAt(edit.place)
        val base = baseIndentation(lines)
        val new = lines.closed(unclosed(lines), program).map {
            it.moved(base, indentation, program.depthAt(edit.place))
        }
        return resultOf(program, rows.subList(0, line) + new + rows.subList(line, rows.size), new)
    }

    fun move(edit: BlockEdit.Move): BlockEditResult {
        val blocks = program.blocksOf(edit.run) ?: return refused(BlockEditError.NotFound)
        val line = program.lineIndexOf(edit.place) ?: return refused(BlockEditError.NotFound)
        val ids = blocks.mapTo(mutableSetOf()) { it.id }
        if (isInside(edit.place, ids)) return refused(BlockEditError.IntoItself)
        val from = checkNotNull(program.placeOf(edit.run.first))
        val cut = rows.subList(blocks.first().lines.first, blocks.last().lines.last + 1)
        val isSameBranch = edit.place.parent == from.parent && edit.place.slot == from.slot
        if (isSameBranch && edit.place.index in from.index..from.index + blocks.size) return unchanged(cut)
        program.errorAt(edit.place, blocks, ids)?.let { return refused(it) }
        val deeper = program.depthAt(edit.place) - program.depthAt(from)
        val base = baseIndentation(cut)
        val indentation = program.indentationAt(edit.place, ids)
        val moved = cut.map { it.moved(base, indentation, deeper) }
        val first = blocks.first().lines.first
        val after = blocks.last().lines.last + 1
        val all = if (line <= first) {
            rows.subList(0, line) + moved + rows.subList(line, first) + rows.subList(after, rows.size)
        } else {
            rows.subList(0, first) + rows.subList(after, line) + moved + rows.subList(line, rows.size)
        }
        return resultOf(program, all, moved)
    }

    private fun unchanged(selected: List<Row>): BlockEditResult = resultOf(program, rows, selected)

    private fun isInside(place: BlockPlace, blocks: Set<BlockId>): Boolean =
        generateSequence(place.parent) { program.placeOf(it)?.parent }.any { it in blocks }

    fun duplicate(edit: BlockEdit.Duplicate): BlockEditResult {
        val blocks = program.blocksOf(edit.run) ?: return refused(BlockEditError.NotFound)
        val place = checkNotNull(program.placeOf(blocks.last().id)).next
        program.errorAt(place, blocks)?.let { return refused(it) }
        val after = blocks.last().lines.last + 1
        val copies = rows.subList(blocks.first().lines.first, after).map {
            it.moved(base = "", indentation = "", depth = 0)
        }
        return resultOf(program, rows.subList(0, after) + copies + rows.subList(after, rows.size), copies)
    }

    fun delete(edit: BlockEdit.Delete): BlockEditResult {
        val blocks = edit.blocks.map { program[it] ?: return refused(BlockEditError.NotFound) }
        if (blocks.isEmpty()) return refused(BlockEditError.NotFound)
        val isDeleted = BooleanArray(rows.size)
        for (block in blocks) for (line in block.lines) isDeleted[line] = true
        val left = rows.filterIndexed { index, _ -> !isDeleted[index] }
        return resultOf(program, left, selected = emptyList(), caret = isDeleted.indexOf(true))
    }
}
