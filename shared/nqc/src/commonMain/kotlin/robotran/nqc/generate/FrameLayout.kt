package robotran.nqc.generate

import robotran.language.source.SourceRange
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Statement
import robotran.nqc.tree.Variable

/**
 * A task, a subroutine, or one use of a function, whose code is being generated.
 *
 * @property globals the global variables.
 * @property call where a function of the API is called; null in the program's own code.
 * @property task the number of the running task; null if a subroutine has several.
 * @property depth how many functions are around.
 */
internal class FrameLayout(
    private val globals: Map<Variable, Expression>,
    val call: SourceRange?,
    val task: Int?,
    val depth: Int,
    val labels: Map<String, Label>,
    private val targets: Set<Statement>,
) {
    private val bindings = HashMap<Variable, Expression>()

    /** The labels of the cases of the `switch` statements around, the innermost last. */
    val switches = mutableListOf<Map<Statement.Case, Label>>()

    fun bind(variable: Variable, expression: Expression) {
        bindings[variable] = expression
    }

    /** A use of a function within this frame. */
    fun within(call: SourceRange?, depth: Int, labels: Map<String, Label>, targets: Set<Statement>) =
        FrameLayout(globals, call, task, depth, labels, targets)

    fun binding(variable: Variable): Expression? = bindings[variable] ?: globals[variable]

    /** Whether [statement] can be reached by `goto` or as a case although nothing leads into it. */
    fun mustEmit(statement: Statement): Boolean = statement in targets || hasCase(statement)

    private fun hasCase(statement: Statement): Boolean = switches.isNotEmpty() && statement !is Statement.Switch &&
        (statement is Statement.Case || statement.parts.any { hasCase(it) })
}
