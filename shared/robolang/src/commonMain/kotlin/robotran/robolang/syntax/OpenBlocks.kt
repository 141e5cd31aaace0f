package robotran.robolang.syntax

import robotran.robolang.diagnostic.SourceRange

/** A block whose end has been found. */
internal class Block(val range: SourceRange, val endRange: SourceRange, val body: List<Statement>)

/**
 * A block that is open at the line being parsed.
 *
 * @property keyword what it begins with.
 * @property complete what becomes of it, null if it is no statement.
 */
internal class OpenBlock(
    val keyword: Token,
    val range: SourceRange,
    val choice: OpenChoice? = null,
    val complete: (Block) -> Statement?,
) {
    /** The statements so far, of the present branch in a choice. */
    var statements = mutableListOf<Statement>()
}

/** The blocks that are open at the line being parsed, each with the statements it has so far. */
internal class OpenBlocks {
    private val main = mutableListOf<Statement>()
    private val open = ArrayDeque<OpenBlock>()
    private val ends = BlockEnds()
    private val closedEarly = mutableListOf<MissingEnd>()
    private var unknown = 0
    private var openChoices = 0

    /** True if a line that was not understood may have opened a block. */
    var isDoubtful = false
        private set

    /** True if no further block can be opened inside the present one. */
    val isFull: Boolean get() = open.size >= RobolangLimits.NESTED_BLOCKS

    /** True inside a block that should not have been opened. */
    val isOverfull: Boolean get() = open.size > RobolangLimits.NESTED_BLOCKS

    val innermost: OpenBlock? get() = open.lastOrNull()

    fun add(statement: Statement) {
        present().add(statement)
    }

    /**
     * Begins [block]; one too deep inside others is read, but the statements in it count as those of the block around
     * it.
     */
    fun open(block: OpenBlock) {
        ends.opened(block.keyword)
        open.addLast(block)
        if (block.choice != null) openChoices++
    }

    /** A line that was not understood may begin a block. */
    fun openUnknown() {
        unknown++
        isDoubtful = true
    }

    /** Ends the innermost block with [keyword]. False if there is none, not even one that was not understood. */
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

    /** Ends the innermost block with [word], which is probably meant as its `end`. */
    fun closeUnsurely(word: Token) {
        close(word.copy(keyword = Keyword.END))
        isDoubtful = true
    }

    /** Ends the innermost blocks that [lack] an `end`, which belongs before [line]. */
    fun closeLacking(line: Int, lack: (OpenBlock) -> Boolean) {
        while (open.isNotEmpty() && lack(open.last())) {
            ends.forget(open.last().keyword)
            closedEarly += MissingEnd(open.last().keyword, endBefore = line)
            closeInnermost(SourceRange(line, 1, 1))
        }
    }

    val hasOpenChoice: Boolean get() = openChoices > 0

    fun lackingEnds(): List<MissingEnd> = closedEarly + ends.lacking(open.size)

    /** The whole program; blocks still open end at [end]. */
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
