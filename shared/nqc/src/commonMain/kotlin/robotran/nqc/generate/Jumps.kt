package robotran.nqc.generate

import robotran.nqc.tree.Statement

/** The labels of the body of a task, subroutine or function, and what `goto` can reach there. */
internal class Jumps(body: Statement) {
    /** All labels in their order; a name twice is a mistake. */
    val labels = mutableListOf<Statement.Label>()

    /** The statements on the way to a label that a `goto` from outside of them jumps to. */
    val targets = HashSet<Statement>()

    private val pathsOfLabels = HashMap<String, List<Statement>>()
    private val pathsOfGotos = mutableListOf<Pair<Statement.Goto, Set<Statement>>>()

    init {
        visit(body, mutableListOf())
        for ((goto, path) in pathsOfGotos) {
            pathsOfLabels[goto.label]?.let { way -> targets += way.filter { it !in path } }
        }
    }

    private fun visit(statement: Statement, path: MutableList<Statement>) {
        path += statement
        if (statement is Statement.Label) {
            labels += statement
            if (statement.name !in pathsOfLabels) pathsOfLabels[statement.name] = path.toList()
        }
        if (statement is Statement.Goto) pathsOfGotos += statement to path.toSet()
        statement.parts.forEach { visit(it, path) }
        path.removeAt(path.lastIndex)
    }
}
