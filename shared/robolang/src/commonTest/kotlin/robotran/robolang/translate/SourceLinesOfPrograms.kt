package robotran.robolang.translate

import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements

/** The lines of a program that have a translation: all but blank lines and the header's first and last line. */
internal fun linesWithJava(tree: SyntaxTree): List<Int> {
    val routines = tree.routines.flatMap { listOf(it.range.line, it.endRange.line) }
    val behaviours = tree.behaviours.flatMap { listOf(it.range.line, it.endRange.line) }
    val statements = allStatements(tree).flatMap { statement ->
        listOfNotNull(
            statement.range.line,
            (statement as? Statement.Block)?.endRange?.line,
            (statement as? Statement.If)?.otherwise?.range?.line,
        ) + (statement as? Statement.If)?.branches.orEmpty().map { it.range.line }
    }
    return (routines + behaviours + statements + tree.comments.map { it.range.line }).distinct().sorted()
}
