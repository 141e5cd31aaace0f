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
fun describe(before: BlockProgram, edit: BlockEdit, done: BlockEditResult.Done, messages: BlockMessages): String {
    val deed = edit.deed
    if (deed == BlockDeed.DELETED) {
        val blocks = (edit as? BlockEdit.Delete)?.blocks.orEmpty().mapNotNull { before[it] }
        return messages.deed(deed, what(before, blocks, messages))
    }
    if (deed == BlockDeed.CHANGED) {
        return messages.deed(deed, spoken(done.program, done.program.lineAt(done.selection.start)))
    }
    val blocks = done.selected.mapNotNull { done.program[it] }
    val place = blocks.firstOrNull()?.let { describe(done.program, it.id, messages) }?.place(messages)
    return messages.deed(deed, listOfNotNull(what(done.program, blocks, messages), place).joinToString(", "))
}

/** A block in words, or how many there are. */
private fun what(program: BlockProgram, blocks: List<Block>, messages: BlockMessages): String =
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
