package robotran.workshop.blocks

import robotran.blockediting.BlockId
import robotran.blockediting.BlockProgram

/**
 * A program as rows of blocks.
 *
 * @property collapsed the blocks whose inside is hidden. It may have blocks that the program lost: undo brings them back.
 */
class BlockList(val program: BlockProgram, val collapsed: Set<BlockId> = emptySet()) {
    val rows: List<BlockRow> by lazy(LazyThreadSafetyMode.NONE) { rowsOf(program) { it.id in collapsed } }

    private val indices: Map<BlockCursor, Int> by lazy(LazyThreadSafetyMode.NONE) {
        buildMap { rows.forEachIndexed { index, row -> row.cursor?.let { put(it, index) } } }
    }

    /** The index of the row of [cursor]; null if it is hidden or not there. */
    fun rowOf(cursor: BlockCursor): Int? = indices[cursor]

    /** The index of the row that shows the line [index], from 0; that of the collapsed block that hides it. */
    fun rowOfLine(index: Int): Int? {
        val block = program.blockOfLine(index) ?: return null
        val own = listOf(BlockCursor.At(block.id), BlockCursor.End(block.id))
            .firstOrNull { program.lineOf(it)?.index == index }
        own?.let { rowOf(it) }?.let { return it }
        val branch = rows.indexOfFirst { it is BlockRow.Branch && it.line.index == index }
        if (branch >= 0) return branch
        return generateSequence(block.id) { program.placeOf(it)?.parent }
            .firstNotNullOfOrNull { rowOf(BlockCursor.At(it)) }
    }
}
