package robotran.robolang.syntax

import robotran.language.source.SourceRange
import robotran.robolang.words.Keyword

/** A block whose end has been found. */
internal class Block(val range: SourceRange, val endRange: SourceRange, val body: List<Statement>)

/**
 * A block that is open at the current line.
 *
 * @property keyword its first keyword.
 * @property complete makes the statement from the block's body; null if it is not a statement.
 */
internal class OpenBlock(
    val keyword: Token,
    val range: SourceRange,
    val choice: OpenChoice? = null,
    val complete: (Block) -> Statement?,
) {
    /** The statements so far; in a choice, those of the current branch. */
    var statements = mutableListOf<Statement>()
}

/** The stack of open blocks, each with its statements so far. */
internal class OpenBlocks {
    private val main = mutableListOf<Statement>()
    private val open = ArrayDeque<OpenBlock>()
    private val ends = BlockEnds()
    private val closedEarly = mutableListOf<MissingEnd>()
    private var unknown = 0
    private var openChoices = 0

    /** Whether an unknown line may have opened a block. */
    var isUncertain = false
        private set

    /** Whether the max nesting depth is reached. */
    val isFull: Boolean get() = open.size >= RobolangLimits.NESTED_BLOCKS

    /** Whether the current block exceeds the max nesting depth. */
    val isOverfull: Boolean get() = open.size > RobolangLimits.NESTED_BLOCKS

    val innermost: OpenBlock? get() = open.lastOrNull()

    fun add(statement: Statement) {
        present().add(statement)
    }

    /** Opens [block]. If it exceeds the max nesting depth, its statements count as those of the surrounding block. */
    fun open(block: OpenBlock) {
        ends.opened(block.keyword)
        open.addLast(block)
        if (block.choice != null) openChoices++
    }

    /** Called for an unknown line that may begin a block. */
    fun openUnknown() {
        unknown++
        isUncertain = true
    }

    /** Closes the innermost block with [keyword]. Returns false if no block is open, not even an unknown one. */
    fun close(keyword: Token): Boolean {
        if (open.isNotEmpty()) {
            ends.closed(keyword)
            closeInnermost(keyword.range)
            return true
        }
        if (unknown == 0) return false
        unknown--
        return true
    }

    /** Closes the innermost block with [word], which is probably meant as its `end`. */
    fun closeUnsurely(word: Token) {
        close(word.copy(keyword = Keyword.END))
        isUncertain = true
    }

    /** Closes the innermost blocks that [lack] an `end` before [line]. */
    fun closeLacking(line: Int, lack: (OpenBlock) -> Boolean) {
        while (open.isNotEmpty() && lack(open.last())) {
            ends.forget(open.last().keyword)
            closedEarly += MissingEnd(open.last().keyword, endBefore = line)
            closeInnermost(SourceRange(line, 1, 1))
        }
    }

    val hasOpenChoice: Boolean get() = openChoices > 0

    fun lackingEnds(): List<MissingEnd> = closedEarly + ends.lacking(open.size)

    /** The whole program; closes all open blocks at [end]. */
    fun program(end: SourceRange): List<Statement> {
        while (open.isNotEmpty()) closeInnermost(end)
        return main
    }

    private fun closeInnermost(endRange: SourceRange) {
        val isTooDeep = isOverfull
        val block = open.removeLast()
        if (block.choice != null) openChoices--
        if (isTooDeep) {
            present().addAll(block.statements)
        } else {
            block.complete(Block(block.range, endRange, block.statements))?.let { present().add(it) }
        }
    }

    private fun present(): MutableList<Statement> = open.lastOrNull()?.statements ?: main
}
