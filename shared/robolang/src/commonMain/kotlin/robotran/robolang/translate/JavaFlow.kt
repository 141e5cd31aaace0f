package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.SymbolKind
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement

/** Java's reachability rules: it rejects statements that it considers unreachable. */
internal class JavaFlow(private val program: CheckedProgram) {
    /** Whether the end of [statements] is reachable. */
    fun completes(statements: List<Statement>): Boolean = statements.all(::completes)

    /** Whether the end of [statement] is reachable. */
    fun completes(statement: Statement): Boolean = when (statement) {
        is Statement.Break, is Statement.Continue, is Statement.Return -> false
        is Statement.Loop -> !isEndless(statement) || breaks(statement.body)

        is Statement.If -> statement.branches.any { completes(it.body) } ||
            statement.otherwise?.let { completes(it.body) } ?: true

        is Command, is Statement.Declare, is Statement.Assign, is Statement.Call, is Statement.Halt -> true
    }

    /** Whether [loop] becomes Java's `while (true)`, which only a `break` ends. */
    fun isEndless(loop: Statement.Loop): Boolean = when (loop) {
        is Statement.RepeatForever -> true
        is Statement.RepeatWhile -> isTruth(loop.condition, true)
        is Statement.RepeatUntil -> isTruth(loop.condition, false)
        is Statement.Repeat, is Statement.ForRange, is Statement.ForEach -> false
    }

    /** Whether [expression] is constant for Java, which then treats it as such in reachability. */
    fun isConstant(expression: Expression): Boolean = when (expression) {
        is Expression.Number, is Expression.BooleanLiteral, is Expression.ColourLiteral -> true
        is Expression.Variable -> program.symbolOf(expression.name).kind == SymbolKind.CONSTANT
        is Expression.Unary -> isConstant(expression.operand)
        is Expression.Binary -> isConstant(expression.left) && isConstant(expression.right)
        is Expression.Brackets -> isConstant(expression.inner)
        is Expression.ListOf, is Expression.ListElement, is Expression.Call, is Expression.Sense -> false
    }

    private fun isTruth(expression: Expression, value: Boolean): Boolean = when (expression) {
        is Expression.BooleanLiteral -> expression.value == value
        is Expression.Brackets -> isTruth(expression.inner, value)
        else -> false
    }

    /** Whether a reachable `break` in [statements] leaves their loop. */
    private fun breaks(statements: List<Statement>): Boolean {
        for (statement in statements) {
            val found = when (statement) {
                is Statement.Break -> true

                is Statement.If -> statement.branches.any { breaks(it.body) } ||
                    statement.otherwise?.let { breaks(it.body) } == true

                else -> false
            }
            if (found) return true
            if (!completes(statement)) return false
        }
        return false
    }
}
