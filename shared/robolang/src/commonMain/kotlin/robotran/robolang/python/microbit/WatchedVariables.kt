package robotran.robolang.python.microbit

import robotran.robolang.check.Symbol
import robotran.robolang.check.Uses
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.leadingDeclarations
import robotran.robolang.syntax.withParts

/** What the conditions of behaviours depend on in the program itself: when that changes, they are looked at. */
internal class WatchedVariables(private val context: PythonContext) {
    private val program = context.program
    private val tree = context.tree
    private val routines = tree.routines.associateBy { it.name.key }

    private val usesOfConditions: Uses by lazy(LazyThreadSafetyMode.NONE) {
        val uses = Uses()
        tree.behaviours.forEach { uses.add(it.condition) }
        val seen = mutableSetOf<String>()
        while (true) {
            val next = uses.calls.mapNotNull { routines[it.key] }.firstOrNull { seen.add(it.name.key) } ?: break
            uses.add(next.body)
        }
        uses
    }

    private val variables: Set<Symbol> by lazy(LazyThreadSafetyMode.NONE) {
        usesOfConditions.variables.map(program::symbolOf).filter { it.isGlobal }.toSet()
    }

    /** Whether a condition calls a routine of the program. */
    val callRoutines: Boolean by lazy(LazyThreadSafetyMode.NONE) { usesOfConditions.calls.any { it.key in routines } }

    /** Whether routines run before the variables of all conditions are declared. */
    val isCalledEarly: Boolean
        get() = tree.leadingDeclarations.flatMap { it.expressions }.flatMap(::withParts)
            .any { it is Expression.Call && it.name.key in routines }

    /** Whether a condition may become true by [statement] alone. */
    fun changes(statement: Statement): Boolean {
        if (!context.isReacting) return false
        return when (statement) {
            is Statement.Assign -> when (val target = statement.target) {
                is AssignTarget.Variable -> program.symbolOf(target.name) in variables
                is AssignTarget.ListElement -> variables.any { it.type.isList }
            }

            is Command.ResetTimer -> allExpressions(tree).any { (it as? Expression.Sense)?.sense == Sense.Timer }

            else -> false
        }
    }
}
