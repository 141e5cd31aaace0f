package robotran.robolang.check

import robotran.robolang.DiagnosticCode
import robotran.robolang.RobolangLimits
import robotran.robolang.SourceRange
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts

/** Finds what a real brick has no room for. */
internal class LimitChecker(private val context: CheckContext) {
    private val messages = context.messages
    private val constants = mutableSetOf<Any>()

    fun check() {
        val tree = context.tree
        tree.statements.forEach { statement(it, isRepeated = false) }
        for (routine in tree.routines) routine.body.forEach { statement(it, isRepeated = false) }
        for (behaviour in tree.behaviours) {
            expression(behaviour.condition, isRepeated = true)
            behaviour.body.forEach { statement(it, isRepeated = true) }
        }
    }

    private fun statement(statement: Statement, isRepeated: Boolean) {
        val looksEachRound = statement is Statement.RepeatWhile || statement is Statement.RepeatUntil || statement is Statement.WaitUntil
        statement.expressions.forEach { expression(it, isRepeated || looksEachRound) }
        if (statement is Statement.ShowText) count(statement.text, statement.textRange)
        statement.bodies.forEach { body -> body.forEach { statement(it, isRepeated || statement is Statement.Loop) } }
    }

    private fun expression(expression: Expression, isRepeated: Boolean) {
        expression.parts.forEach { expression(it, isRepeated) }
        when (expression) {
            is Expression.ListOf -> if (isRepeated) context.warn(DiagnosticCode.LIST_IN_LOOP, expression.range, messages.listInLoop())
            is Expression.Number -> number(expression)
            else -> Unit
        }
    }

    private fun number(expression: Expression.Number) {
        val value = expression.value
        val isSmall = value is NumberValue.Whole && value.value in Short.MIN_VALUE..Short.MAX_VALUE
        if (!isSmall) count(value, expression.range)
    }

    private fun count(constant: Any, range: SourceRange) {
        if (constants.add(constant) && constants.size == RobolangLimits.CONSTANTS + 1) {
            context.report(DiagnosticCode.TOO_MANY_CONSTANTS, range, messages.tooManyConstants(RobolangLimits.CONSTANTS))
        }
    }
}
