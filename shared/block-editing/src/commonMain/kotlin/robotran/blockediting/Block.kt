package robotran.blockediting

import robotran.robolang.outline.OutlineLine

/** Identifies a block in its program. A block that an edit does not change keeps its number, also when it moves. */
data class BlockId(val number: Int)

/**
 * A block: one line of the program, or a construct of several. Blocks cover whole lines, so that all blocks of a program
 * in order are its text.
 */
sealed interface Block {
    val id: BlockId

    /** Its first line. */
    val head: OutlineLine

    /** The indices of its lines. */
    val lines: IntRange get() = head.index..head.index

    /** A command of one line. */
    class Command internal constructor(override val id: BlockId, override val head: OutlineLine) : Block

    /**
     * A block with others inside, such as `repeat` or `if`.
     *
     * @property head its first line. If it has a mistake, its form is null; what is inside is read nevertheless.
     * @property slots its branches: one, or for an `if` also one for each `else if` and `else`.
     * @property foot its `end`; null if that is missing.
     */
    class Construct internal constructor(
        override val id: BlockId,
        override val head: OutlineLine,
        val slots: List<BlockSlot>,
        val foot: OutlineLine?,
    ) : Block {
        override val lines: IntRange = head.index..(foot?.index ?: slots.last().lastLine)
    }

    /** A line with a mistake, shown as text. Its [head] may have a message and a fix. */
    class Loose internal constructor(override val id: BlockId, override val head: OutlineLine) : Block

    /** A comment on a line of its own. */
    class Comment internal constructor(override val id: BlockId, override val head: OutlineLine) : Block

    /** An empty line. */
    class Blank internal constructor(override val id: BlockId, override val head: OutlineLine) : Block
}

/**
 * A branch of a [Block.Construct].
 *
 * @property head the line that begins it: the first line of the construct, or an `else`.
 * @property blocks what is inside, in order.
 */
class BlockSlot internal constructor(val head: OutlineLine, val blocks: List<Block>) {
    internal val lastLine: Int get() = blocks.lastOrNull()?.lines?.last ?: head.index
}

/**
 * A place between blocks.
 *
 * @property parent the construct around it; null for the program itself.
 * @property slot which of its branches, from 0.
 * @property index how many blocks of that branch stand before it.
 */
data class BlockPlace(val parent: BlockId?, val slot: Int, val index: Int) {
    /** The place behind the block that stands here. */
    val next: BlockPlace get() = copy(index = index + 1)
}
