package robotran.workshop.blocks

import robotran.blockediting.Block
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.robolang.outline.OutlineLine
import robotran.robolang.words.BlockGroup

/**
 * A row of the list in which blocks are shown. A block with others inside has a row for each of its own lines, so that
 * only the visible rows of a long program need to be drawn.
 */
sealed interface BlockRow {
    val block: Block

    /** The groups of the blocks around the row, the outermost first. */
    val around: List<BlockGroup>

    /** The line of the program; null if there is none. */
    val line: OutlineLine?

    /** Its place for the keyboard; null if the keyboard skips it. */
    val cursor: BlockCursor?

    /** The same for the same row of the next program. */
    val key: String

    /** A block of one line, or the first line of one with others inside. */
    class First(override val block: Block, override val around: List<BlockGroup>, val isCollapsed: Boolean) : BlockRow {
        override val line: OutlineLine get() = block.head
        override val cursor: BlockCursor get() = BlockCursor.At(block.id)
        override val key: String get() = "${block.id.number}"
    }

    /** The first line of the branch [slot], from 1. */
    class Branch(override val block: Block.Construct, val slot: Int, override val around: List<BlockGroup>) : BlockRow {
        override val line: OutlineLine get() = block.slots[slot].head
        override val cursor: BlockCursor get() = BlockCursor.Branch(block.id, slot)
        override val key: String get() = "${block.id.number}-$slot"
    }

    /** The room in a branch without blocks. */
    class Empty(override val block: Block.Construct, val slot: Int, override val around: List<BlockGroup>) : BlockRow {
        override val line: OutlineLine? get() = null
        override val cursor: BlockCursor? get() = null
        override val key: String get() = "${block.id.number}-room-$slot"
    }

    /** The `end` of a block, also of one whose `end` is missing in the text. */
    class End(override val block: Block.Construct, override val around: List<BlockGroup>) : BlockRow {
        override val line: OutlineLine? get() = block.foot
        override val cursor: BlockCursor get() = BlockCursor.End(block.id)
        override val key: String get() = "${block.id.number}-end"
    }
}

/** The group of the block; null for comments, empty lines and loose text. */
val Block.group: BlockGroup?
    get() = head.form?.group ?: BlockGroup.CONTROL.takeIf { this is Block.Construct }

/** The rows of [program] in order, without what is inside of [BlockList.collapsed] blocks. */
fun rowsOf(program: BlockProgram, isCollapsed: (Block) -> Boolean): List<BlockRow> = buildList {
    addRows(program.blocks, emptyList(), isCollapsed)
}

/** The depth of recursion is the nesting of blocks, which the language limits. */
private fun MutableList<BlockRow>.addRows(
    blocks: List<Block>,
    around: List<BlockGroup>,
    isCollapsed: (Block) -> Boolean,
) {
    for (block in blocks) {
        val hides = block is Block.Construct && isCollapsed(block)
        add(BlockRow.First(block, around, hides))
        if (block !is Block.Construct || hides) continue
        val inside = around + listOfNotNull(block.group)
        block.slots.forEachIndexed { slot, branch ->
            if (slot > 0) add(BlockRow.Branch(block, slot, around))
            if (branch.blocks.isEmpty()) add(BlockRow.Empty(block, slot, inside))
            addRows(branch.blocks, inside, isCollapsed)
        }
        add(BlockRow.End(block, around))
    }
}

/** Where a block goes that is put directly above this row. */
fun BlockRow.placeAbove(program: BlockProgram): BlockPlace? = when (this) {
    is BlockRow.First -> program.placeOf(block.id)
    is BlockRow.Branch -> program.endOf(block.id, slot - 1)
    is BlockRow.Empty -> BlockPlace(block.id, slot, 0)
    is BlockRow.End -> program.endOf(block.id, block.slots.lastIndex)
}

/** Where a block goes that is put directly below this row. */
fun BlockRow.placeBelow(program: BlockProgram): BlockPlace? = when (this) {
    is BlockRow.First -> {
        if (block is Block.Construct && !isCollapsed) BlockPlace(block.id, 0, 0) else program.placeOf(block.id)?.next
    }

    is BlockRow.Branch -> BlockPlace(block.id, slot, 0)
    is BlockRow.Empty -> BlockPlace(block.id, slot, 0)
    is BlockRow.End -> program.placeOf(block.id)?.next
}
