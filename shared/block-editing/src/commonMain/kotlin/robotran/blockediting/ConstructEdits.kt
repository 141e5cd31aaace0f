package robotran.blockediting

import robotran.robolang.outline.LineRole
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueKind

/** Edits of constructs that keep what is inside. */
internal class ConstructEdits(private val program: BlockProgram) {
    private val rows = program.outline.rows(program.lineCount)

    fun wrap(edit: BlockEdit.Wrap): BlockEditResult {
        val blocks = program.blocksOf(edit.run) ?: return refused(BlockEditError.NotFound)
        val place = checkNotNull(program.placeOf(edit.run.first))
        val fragment = fragmentOf(program, edit.construct)
        val construct =
            fragment.blocks.singleOrNull() as? Block.Construct ?: return refused(BlockEditError.NoSuchConstruct)
        if (construct.head.form == LineForm.ROBOT) return refused(BlockEditError.OnlySettings)
        program.errorAt(place, listOf(construct))?.let { return refused(it) }
        if (blocks.any { it.head.form?.isOutermost == true }) return refused(BlockEditError.OnlyOutermost)
        val first = blocks.first().lines.first
        val after = blocks.last().lines.last + 1
        val inside = rows.subList(first, after)
        val base = baseIndentation(inside)
        val target = if (inside.all { it.isBlank }) program.indentationAt(place) else base
        val own = fragment.outline.rows(fragment.lineCount).let { it.closed(unclosed(it), program) }
            .map { it.moved(base = "", target, program.depthAt(place)) }
        val wrapped = own.take(1) + inside.map { it.moved(base, target + INDENTATION, depth = 1) } +
            own.drop(construct.slots.first().lastLine + 1)
        return resultOf(program, rows.subList(0, first) + wrapped + rows.subList(after, rows.size), wrapped)
    }

    fun unwrap(edit: BlockEdit.Unwrap): BlockEditResult {
        val construct = construct(edit.construct) ?: return refused(BlockEditError.NoSuchConstruct)
        val place = checkNotNull(program.placeOf(construct.id))
        val content = construct.slots.flatMap { it.blocks }
        program.errorAt(place, content)?.let { return refused(it) }
        val indentation = indentationOf(rows[construct.head.index].content)
        val kept = construct.slots.flatMap { slot ->
            val inside = rows.subList(slot.head.index + 1, slot.lastLine + 1)
            val base = baseIndentation(inside)
            comment(slot.head, indentation) + inside.map { it.moved(base, indentation, depth = -1) }
        } + construct.foot?.let { comment(it, indentation) }.orEmpty()
        val all = rows.subList(0, construct.lines.first) + kept + rows.subList(construct.lines.last + 1, rows.size)
        return resultOf(program, all, kept, construct.lines.first)
    }

    private fun comment(line: OutlineLine, indentation: String): List<Row> = listOfNotNull(
        line.comment?.let {
            Row(indentation + it.textIn(program.text), null, LineRole.COMMENT, line.depth, origin = null)
        },
    )

    fun addElse(edit: BlockEdit.AddElse): BlockEditResult {
        val construct = construct(edit.construct)?.takeIf { it.head.form == LineForm.IF }
            ?: return refused(BlockEditError.NoSuchConstruct)
        val otherwise = construct.slots.firstOrNull { it.head.form == LineForm.ELSE }
        val condition = edit.condition
        if (condition == null && otherwise != null) return refused(BlockEditError.ElseExists)
        if (condition != null) conditionError(condition)?.let { return refused(it) }
        val words = if (condition == null) "else" else "else if " + condition.trim()
        val indentation = indentationOf(rows[construct.head.index].content)
        val branch =
            Row(indentation + program.inWords(words), null, LineRole.BRANCHES, construct.head.depth, origin = null)
        val line = otherwise?.head?.index ?: (construct.slots.last().lastLine + 1)
        return resultOf(program, rows.subList(0, line) + branch + rows.subList(line, rows.size), listOf(branch))
    }

    private fun conditionError(condition: String): BlockEditError? {
        val line = fragmentOf(program, "if $condition").outline.lines
        val value = line.first().parts.filterIsInstance<PhrasePart.Value>().singleOrNull()
        if (line.size > 1 || value == null || line.first().comment != null) {
            return BlockEditError.NoValue(condition, line.first().error)
        }
        val kind = literalKind(value.value.form)
        return if (kind == null || kind == ValueKind.CONDITION) null else BlockEditError.ConditionNeeded
    }

    fun removeElse(edit: BlockEdit.RemoveElse): BlockEditResult {
        val construct = construct(edit.construct) ?: return refused(BlockEditError.NoSuchConstruct)
        val slot = construct.slots.getOrNull(edit.slot)?.takeIf { edit.slot > 0 }
            ?: return refused(BlockEditError.NotFound)
        val left = rows.subList(0, slot.head.index) + rows.subList(slot.lastLine + 1, rows.size)
        return resultOf(program, left, listOf(rows[construct.head.index]))
    }

    private fun construct(id: BlockId): Block.Construct? = program[id] as? Block.Construct
}
