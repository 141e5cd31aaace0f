package robotran.tower.transfer

import robotran.tower.Blocks

/**
 * The size of the next block: it falls with blocks that had to be sent several times and rises with blocks that got
 * through at once.
 *
 * A block that was sent once keeps its size: if only its answer was lost, the brick has it already and ignores another
 * one. So a block that never gets through can only be made smaller by beginning the whole download again.
 */
internal class BlockSize {
    private var level = 0
    private var clearBlocks = 0

    /** Data bytes. */
    val bytes get() = Blocks.SIZES[level]

    val isSmallest get() = level == Blocks.SIZES.lastIndex

    /** Whether the line is so disturbed that a last block of one byte is worth its overhead. */
    val isSmall get() = level >= Blocks.SIZES.lastIndex - 1

    /** A block was confirmed after [attempts]. */
    fun confirmed(attempts: Int) {
        clearBlocks = if (attempts == 1) clearBlocks + 1 else 0
        when {
            attempts > 2 -> smaller()
            clearBlocks >= Blocks.UNTIL_LARGER && level > 0 -> larger()
        }
    }

    fun smaller() {
        if (!isSmallest) level++
        clearBlocks = 0
    }

    private fun larger() {
        level--
        clearBlocks = 0
    }
}
