package robotran.robolang.check

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts
import robotran.robolang.syntax.shortened

/** Finds routines that always call themselves, so that the brick runs out of memory. */
internal class EndlessRecursion(private val context: CheckContext) {
    fun check() {
        val tree = context.tree
        val bodies = tree.routines.map { it.body } + tree.behaviours.map { it.body } + listOf(tree.statements)
        if (bodies.any { body -> body.any(::mayHalt) }) return
        for (routine in tree.routines) {
            if (SelfCalls(routine).areCertainIn(routine.body)) {
                val message = context.messages.endlessRecursion(shortened(routine.name.text))
                context.warn(DiagnosticCode.ENDLESS_RECURSION, routine.name.range, message)
            }
        }
    }

    private fun mayHalt(statement: Statement): Boolean =
        statement is Statement.Halt || statement.bodies.any { body -> body.any(::mayHalt) }

    private inner class SelfCalls(private val routine: Routine) {
        fun areCertainIn(statements: List<Statement>): Boolean {
            for (statement in statements) {
                if (isCertainIn(statement)) return true
                if (mayLeave(statement)) return false
            }
            return false
        }

        private fun isCertainIn(statement: Statement): Boolean = when (statement) {
            is Statement.If -> isCertainIn(statement.branches.first().condition) ||
                (statement.otherwise != null && statement.bodies.all(::areCertainIn))

            is Statement.RepeatForever -> areCertainIn(statement.body)
            is Statement.Call -> isSelf(statement.name) || statement.arguments.any(::isCertainIn)
            else -> statement.expressions.any(::isCertainIn)
        }

        private fun isCertainIn(expression: Expression): Boolean = when (expression) {
            is Expression.Call -> isSelf(expression.name) || expression.arguments.any(::isCertainIn)

            is Expression.Binary -> isCertainIn(expression.left) ||
                (expression.operator !in DECIDING && isCertainIn(expression.right))

            else -> expression.parts.any(::isCertainIn)
        }

        private fun isSelf(name: Name): Boolean = context.routineOf(name)?.range == routine.range

        private fun mayLeave(statement: Statement): Boolean =
            statement is Statement.Return || statement is Statement.Break ||
                statement is Statement.Continue || statement.bodies.any { body -> body.any(::mayLeave) }
    }

    private companion object {
        /** Operators that may skip their right operand. */
        val DECIDING = setOf(BinaryOperator.AND, BinaryOperator.OR)
    }
}
