package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.allStatements

/** Finds expressions whose value never changes, so that a loop can evaluate them in each round. */
internal class InvariantExpressions(private val program: CheckedProgram) {
    private val changed: Set<Symbol> = allStatements(program.tree)
        .mapNotNull { ((it as? Statement.Assign)?.target as? AssignTarget.Variable)?.name }
        .map(program::symbolOf)
        .toSet()

    /** Whether [expression] consists of numbers and variables that are never assigned, and cannot fail. */
    fun isSteady(expression: Expression): Boolean = when (expression) {
        is Expression.Number, is Expression.BooleanLiteral, is Expression.ColourLiteral -> true
        is Expression.Variable -> program.symbolOf(expression.name) !in changed
        is Expression.Unary -> expression.operator == UnaryOperator.MINUS && isSteady(expression.operand)
        is Expression.Binary -> isSafe(expression) && isSteady(expression.left) && isSteady(expression.right)
        is Expression.Brackets -> isSteady(expression.inner)
        is Expression.Call -> isLength(expression) && isSteady(expression.arguments.single())
        is Expression.ListOf, is Expression.ListElement, is Expression.Sense -> false
    }

    /**
     * The length of a list if [last] is that minus one, the index of its last element: Java then counts up to the
     * length.
     */
    fun countBehind(last: Expression): Expression? {
        val difference = last as? Expression.Binary ?: return null
        val isOneLess =
            difference.operator == BinaryOperator.MINUS &&
                (difference.right as? Expression.Number)?.value == NumberValue.Whole(1)
        return difference.left.takeIf { isOneLess && isSteady(it) && it is Expression.Call }
    }

    private fun isLength(call: Expression.Call): Boolean =
        program.symbolOf(call.name).declaredAt == null && BuiltIn.of(call.name.key) == BuiltIn.LENGTH

    private fun isSafe(expression: Expression.Binary): Boolean = when (expression.operator) {
        BinaryOperator.PLUS, BinaryOperator.MINUS, BinaryOperator.TIMES -> true
        BinaryOperator.DIVIDE -> (expression.right as? Expression.Number)?.value?.decimal.let { it != null && it != 0f }
        else -> false
    }
}
