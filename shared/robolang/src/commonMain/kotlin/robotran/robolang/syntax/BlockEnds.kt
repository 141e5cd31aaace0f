package robotran.robolang.syntax

import robotran.robolang.words.Keyword

/** What a line does to the blocks around it. [MAY_OPEN] is a misspelt line that was perhaps meant to open one. */
internal enum class BlockEdge { OPENS, MAY_OPEN, ELSE, ELSE_IF, CLOSES }

/**
 * A block without an `end`.
 *
 * @property opener the keyword at its start.
 * @property endBefore the line before which its `end` is missing; null for the end of the program.
 */
internal data class MissingEnd(val opener: Token, val endBefore: Int?)

/**
 * Finds the blocks that lack an `end`. Counting alone would always blame the outermost block. Indentation tells more:
 * an `end` exactly below the start of an outer block closes that block, so the blocks inside it lack theirs.
 */
internal class BlockEnds {
    private val edges = mutableListOf<Token>()

    fun opened(keyword: Token) {
        edges += keyword
    }

    fun closed(keyword: Token) {
        edges += keyword
    }

    /** Called when a missing `end` of the block that starts with [keyword] was reported already. */
    fun forget(keyword: Token) {
        edges.removeAt(edges.lastIndexOf(keyword))
    }

    /** The [count] blocks without an `end`. */
    fun lacking(count: Int): List<MissingEnd> {
        if (count == 0) return emptyList()
        val byIndentation = match(byIndentation = true)
        return if (byIndentation.size == count) byIndentation else match(byIndentation = false)
    }

    private fun match(byIndentation: Boolean): List<MissingEnd> {
        val lacking = mutableListOf<MissingEnd>()
        val open = ArrayDeque<Token>()
        val openAtColumn = mutableMapOf<Int, Int>()

        fun close(): Token = open.removeLast().also {
            openAtColumn[it.range.column] = openAtColumn.getValue(it.range.column) - 1
        }
        for (edge in edges) {
            val column = edge.range.column
            if (edge.keyword != Keyword.END) {
                open.addLast(edge)
                openAtColumn[column] = (openAtColumn[column] ?: 0) + 1
                continue
            }
            if (byIndentation && (openAtColumn[column] ?: 0) > 0) {
                while (open.last().range.column > column) lacking += MissingEnd(close(), endBefore = edge.range.line)
            }
            if (open.isNotEmpty()) close()
        }
        while (open.isNotEmpty()) lacking += MissingEnd(close(), endBefore = null)
        return lacking
    }
}
