package robotran.blockediting.describe

import robotran.blockediting.Block
import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockProgram
import robotran.blockediting.messages.BlockMessages

/**
 * Says what [edit] has done, such as `Moved: forward 10 cm, 1 of 3 in repeat 4 times`.
 *
 * @param before the blocks before the edit.
 * @param done what the edit has made of them.
 */
fun describe(before: BlockProgram, edit: BlockEdit, done: BlockEditResult.Success, messages: BlockMessages): String {
    val deed = edit.deed
    if (deed == BlockDeed.DELETED) {
        val blocks = (edit as? BlockEdit.Delete)?.blocks.orEmpty().mapNotNull { before[it] }
        return messages.deed(deed, inWords(before, blocks, messages))
    }
    if (deed == BlockDeed.CHANGED) {
        return messages.deed(deed, spoken(done.program, done.program.lineAt(done.selection.start)))
    }
    val blocks = done.selected.mapNotNull { done.program[it] }
    val place = blocks.firstOrNull()?.let { describe(done.program, it.id, messages) }?.place(messages)
    return messages.deed(deed, listOfNotNull(inWords(done.program, blocks, messages), place).joinToString(", "))
}

/**
 * Says what is different in [after], which was [before] until something was undone or redone: what is there now with its
 * place, such as `Now: beep, 2 of 3 in repeat 4 times`, or what is gone. Null if no line has changed, except for the
 * spaces before it.
 */
fun describeChange(before: BlockProgram, after: BlockProgram, messages: BlockMessages): String? {
    val came = linesWithout(after, before)
    val went = linesWithout(before, after)
    if (came.isEmpty() && went.isNotEmpty()) return messages.gone(what(before, went, messages))
    val lines = came.ifEmpty { listOfNotNull(changedLine(before, after) ?: movedLine(before, after)) }
    if (lines.isEmpty()) return null
    val place = outermost(after, lines).firstOrNull()?.let { describe(after, it.id, messages) }?.place(messages)
    return messages.deed(BlockDeed.CHANGED, listOfNotNull(what(after, lines, messages), place).joinToString(", "))
}

/** The lines of [program] that [other] does not have. */
private fun linesWithout(program: BlockProgram, other: BlockProgram): List<Int> {
    val known = other.lineIds.toSet()
    return program.lineIds.indices.filter { program.lineIds[it] !in known }
}

/** The first line of [after] that says something else than in [before]. */
private fun changedLine(before: BlockProgram, after: BlockProgram): Int? {
    val places = before.lineIds.withIndex().associate { it.value to it.index }
    return after.lineIds.indices.firstOrNull { index ->
        val old = places[after.lineIds[index]]
        old != null && lineOf(before, old) != lineOf(after, index)
    }
}

private fun lineOf(program: BlockProgram, index: Int): String =
    program.outline.lines[index].span.textIn(program.text).trim()

/** A line of [after] that has moved: where two groups of lines have changed places, the first of the smaller one. */
private fun movedLine(before: BlockProgram, after: BlockProgram): Int? {
    val old = before.lineIds
    val new = after.lineIds
    val first = new.indices.firstOrNull { it < old.size && new[it] != old[it] } ?: return null
    val upwards = old.indexOf(new[first])
    val downwards = new.indexOf(old[first])
    return if (upwards <= downwards) downwards else first
}

/** The blocks of [lines] that are in no other of them. */
private fun outermost(program: BlockProgram, lines: List<Int>): List<Block> {
    val heads = lines.toSet()
    return program.all.filter { block ->
        val around = program.placeOf(block.id)?.parent?.let { program[it] }
        block.head.index in heads && (around == null || around.head.index !in heads)
    }
}

/** The blocks of [lines] in words; the first line if none begins there, as with an `else`. */
private fun what(program: BlockProgram, lines: List<Int>, messages: BlockMessages): String {
    val blocks = outermost(program, lines)
    return if (blocks.isEmpty()) {
        spoken(
            program,
            program.outline.lines[lines.first()],
        )
    } else {
        inWords(program, blocks, messages)
    }
}

/** A block in words, or how many there are. */
private fun inWords(program: BlockProgram, blocks: List<Block>, messages: BlockMessages): String =
    blocks.singleOrNull()?.let { spoken(program, it.head).ifEmpty { messages.emptyLine() } }
        ?: messages.blocks(blocks.size.coerceAtLeast(1))

private val BlockEdit.deed: BlockDeed
    get() = when (this) {
        is BlockEdit.Insert -> BlockDeed.ADDED
        is BlockEdit.Move -> BlockDeed.MOVED
        is BlockEdit.Duplicate -> BlockDeed.DOUBLED
        is BlockEdit.Delete -> BlockDeed.DELETED
        is BlockEdit.Wrap, is BlockEdit.Unwrap, is BlockEdit.AddElse, is BlockEdit.RemoveElse, is BlockEdit.Replace,
        is BlockEdit.MoveValue, is BlockEdit.ClearValue, is BlockEdit.UseNewName, is BlockEdit.ChangeForm,
        is BlockEdit.AddItem, is BlockEdit.RemoveItem, is BlockEdit.AddParameter, is BlockEdit.RemoveParameter,
        is BlockEdit.SetNote, is BlockEdit.ReplaceLine, is BlockEdit.ApplyFix, is BlockEdit.Rename,
        -> BlockDeed.CHANGED
    }
