package robotran.robolang.syntax

import robotran.robolang.RobolangLimits

/** The blocks that are open at the line being parsed, each with the statements it has so far. */
internal class OpenBlocks {
    private class OpenBlock(val complete: (body: List<Statement>) -> Statement?) {
        val statements = mutableListOf<Statement>()
    }

    private val main = mutableListOf<Statement>()
    private val open = ArrayDeque<OpenBlock>()
    private val ends = BlockEnds()
    private var unknown = 0

    /** True if no further block can be opened inside the present one. */
    val isFull: Boolean get() = open.size >= RobolangLimits.NESTED_BLOCKS

    /** True inside a block that should not have been opened. */
    val isOverfull: Boolean get() = open.size > RobolangLimits.NESTED_BLOCKS

    fun add(statement: Statement) {
        present().add(statement)
    }

    /**
     * Begins a block with [keyword]. Where its `end` comes, [complete] makes a statement of it; if that gives null or the blocks
     * are nested too deeply, the program cannot run anyway and its statements go to the block around it, so that they are checked.
     */
    fun open(keyword: Token, complete: (body: List<Statement>) -> Statement?) {
        ends.opened(keyword)
        open.addLast(if (isFull) OpenBlock { null } else OpenBlock(complete))
    }

    /** A line that was not understood may begin a block. */
    fun openUnknown() {
        unknown++
    }

    /** Ends the innermost block with [keyword]. False if there is none, not even one that was not understood. */
    fun close(keyword: Token): Boolean {
        if (open.isNotEmpty()) {
            ends.closed(keyword)
            closeInnermost()
            return true
        }
        if (unknown == 0) return false
        unknown--
        return true
    }

    fun lackingEnds(): List<LackingEnd> = ends.lacking(open.size)

    /** The whole program; blocks still open end here. */
    fun program(): List<Statement> {
        while (open.isNotEmpty()) closeInnermost()
        return main
    }

    private fun closeInnermost() {
        val block = open.removeLast()
        val statement = block.complete(block.statements)
        if (statement == null) present().addAll(block.statements) else present().add(statement)
    }

    private fun present(): MutableList<Statement> = open.lastOrNull()?.statements ?: main
}
