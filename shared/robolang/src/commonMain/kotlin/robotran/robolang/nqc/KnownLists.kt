package robotran.robolang.nqc

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.allStatements

/** The lists that can be arrays: of whole numbers, written down where they are declared, and never another list. */
internal class KnownLists(private val program: CheckedProgram) {
    private val statements = allStatements(program.tree)
    private val declared = statements.filterIsInstance<Statement.Declare>().groupBy { program.symbolOf(it.name) }
    private val assigned = statements.filterIsInstance<Statement.Assign>()
        .mapNotNull { (it.target as? AssignTarget.Variable)?.let { target -> program.symbolOf(target.name) } }
        .toSet()

    /** The number of elements of [symbol]'s list; null if it is no such list. */
    fun sizeOf(symbol: Symbol): Int? {
        if (symbol.type != ValueType.LIST_OF_WHOLE || symbol in assigned) return null
        return (declared[symbol]?.singleOrNull()?.value as? Expression.ListOf)?.elements?.size
    }

    /** The same for the list that [expression] names; null for any other expression. */
    fun sizeOf(expression: Expression): Int? =
        (expression as? Expression.Variable)?.let { sizeOf(program.symbolOf(it.name)) }
}
