package robotran.robolang.outline

import robotran.robolang.syntax.BlockEdge
import robotran.robolang.syntax.MissingEnd
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.ScannedLine
import robotran.robolang.words.Keyword
import robotran.robolang.words.isBlank

/** The role of a line and the number of blocks around it. */
internal class LinePlace(val role: LineRole, val depth: Int)

/**
 * Finds the blocks of a program, also of one with mistakes. It agrees with the parser about programs without mistakes.
 * If an `end` is missing, the block stops where the message says that its `end` belongs. A misspelt first line opens a
 * block if an `end` exactly below it closes it.
 *
 * @param edges the lines that open, branch or close blocks, by their number from 1.
 */
internal class BlockStructure(
    private val lines: List<ScannedLine>,
    private val edges: Map<Int, BlockEdge>,
    lacking: List<MissingEnd>,
) {
    private val lackingBefore = lacking.filter { it.endBefore != null }.groupBy { it.endBefore }

    /** The places of all lines, in order. */
    fun places(): List<LinePlace> {
        val closed = mutableSetOf<Int>()
        if (edges.containsValue(BlockEdge.MAY_OPEN)) Pass(null, closed).run()
        return Pass(closed, mutableSetOf()).run()
    }

    private class Open(
        val line: Int,
        val column: Int,
        val isChoice: Boolean,
        val isUnknown: Boolean,
        val isFlat: Boolean,
    ) {
        var isAtElse = false
    }

    /**
     * One pass over the lines.
     *
     * @param misspelt the misspelt lines that open blocks; null for all that may.
     * @param closed receives the misspelt lines that an `end` closes.
     */
    private inner class Pass(private val misspelt: Set<Int>?, private val closed: MutableSet<Int>) {
        private val open = ArrayDeque<Open>()
        private var flat = 0
        private var known = 0
        private var choices = 0
        private val openLines = mutableSetOf<Int>()

        fun run(): List<LinePlace> = lines.map { line ->
            lackingBefore[line.number]?.forEach { closeUpTo(it.opener.range.line) }
            val role = when (val edge = edges[line.number]) {
                null -> plainRole(line)
                BlockEdge.OPENS -> opens(line, isUnknown = false)
                BlockEdge.MAY_OPEN -> mayOpen(line)
                BlockEdge.ELSE, BlockEdge.ELSE_IF -> branches(line, edge)
                BlockEdge.CLOSES -> closes(line)
            }
            val inside = open.size - flat
            LinePlace(role, if (role == LineRole.OPENS || role == LineRole.BRANCHES) inside - 1 else inside)
        }

        private fun plainRole(line: ScannedLine): LineRole = when {
            line.tokens.isNotEmpty() -> LineRole.PLAIN
            line.comment != null -> LineRole.COMMENT
            line.text.all(::isBlank) -> LineRole.BLANK
            else -> LineRole.PLAIN
        }

        private fun mayOpen(line: ScannedLine): LineRole =
            if (misspelt == null || line.number in misspelt) opens(line, isUnknown = true) else LineRole.PLAIN

        private fun opens(line: ScannedLine, isUnknown: Boolean): LineRole {
            val first = line.tokens.first()
            val isFlat = open.size - flat >= RobolangLimits.NESTED_BLOCKS
            open.addLast(Open(line.number, first.range.column, first.keyword == Keyword.IF, isUnknown, isFlat))
            if (isFlat) flat++
            if (!isUnknown) known++
            if (first.keyword == Keyword.IF) choices++
            openLines += line.number
            return if (isFlat) LineRole.PLAIN else LineRole.OPENS
        }

        private fun branches(line: ScannedLine, edge: BlockEdge): LineRole {
            val column = line.tokens.first().range.column
            val top = open.lastOrNull()
            if (top == null || !top.isUnknown || top.column != column) {
                if (choices == 0) return LineRole.PLAIN
                while (!open.last().isChoice) close()
            }
            val block = open.last()
            if (block.isAtElse || block.isFlat) return LineRole.PLAIN
            block.isAtElse = edge == BlockEdge.ELSE
            return LineRole.BRANCHES
        }

        private fun closes(line: ScannedLine): LineRole {
            val column = line.tokens.first().range.column
            while (open.isNotEmpty() && open.last().isUnknown && known > 0 && open.last().column != column) close()
            val block = open.lastOrNull() ?: return LineRole.PLAIN
            close()
            if (block.isUnknown) closed += block.line
            return if (block.isFlat) LineRole.PLAIN else LineRole.CLOSES
        }

        private fun closeUpTo(line: Int) {
            while (line in openLines) close()
        }

        private fun close() {
            val block = open.removeLast()
            if (block.isFlat) flat--
            if (!block.isUnknown) known--
            if (block.isChoice) choices--
            openLines -= block.line
        }
    }
}
