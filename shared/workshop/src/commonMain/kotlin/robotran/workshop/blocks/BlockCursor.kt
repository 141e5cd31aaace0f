package robotran.workshop.blocks

import robotran.blockediting.Block
import robotran.blockediting.BlockId
import robotran.blockediting.BlockProgram
import robotran.robolang.outline.OutlineLine

/** The line of blocks that the keyboard is at. New blocks go below it. */
sealed interface BlockCursor {
    val block: BlockId

    /** A block, or the first line of one that has others inside. */
    data class At(override val block: BlockId) : BlockCursor

    /** The first line of the branch [slot], from 1, such as an `else`. */
    data class Branch(override val block: BlockId, val slot: Int) : BlockCursor

    /** The `end` of a block. */
    data class End(override val block: BlockId) : BlockCursor
}

/** The line of [cursor]; null if there is none, or if the block has no `end`. */
fun BlockProgram.lineOf(cursor: BlockCursor): OutlineLine? {
    val block = get(cursor.block) ?: return null
    return when (cursor) {
        is BlockCursor.At -> block.head
        is BlockCursor.Branch -> (block as? Block.Construct)?.slots?.getOrNull(cursor.slot)?.head
        is BlockCursor.End -> (block as? Block.Construct)?.foot
    }
}
