package robotran.robolang.translate

import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements

/** The lines of a program that are not blank. */
internal class SourceLines(tree: SyntaxTree) {
    private val lines: Set<Int> = buildSet {
        tree.comments.forEach { add(it.range.line) }
        tree.robot?.let {
            addAll(
                (
                    listOf(it.range, it.endRange) + it.settings.map { setting ->
                        setting.range
                    }
                ).map { range -> range.line },
            )
        }
        tree.routines.forEach { addAll(listOf(it.range.line, it.endRange.line)) }
        tree.behaviours.forEach { addAll(listOf(it.range.line, it.endRange.line)) }
        allStatements(tree).forEach { addAll(linesOf(it)) }
    }

    /** Whether there is a blank line directly above [line]. */
    fun isBlankAbove(line: Int): Boolean = line > 1 && line - 1 !in lines

    private fun linesOf(statement: Statement): List<Int> {
        val choice = statement as? Statement.If
        val own = listOfNotNull(statement.range, (statement as? Statement.Block)?.endRange, choice?.otherwise?.range)
        return (own + choice?.branches.orEmpty().map { it.range }).map { it.line }
    }
}
