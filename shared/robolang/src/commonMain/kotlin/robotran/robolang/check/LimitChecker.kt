package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts
import robotran.robolang.words.BrickDialect

/** Finds programs that exceed a real brick: too many constants, and lists created repeatedly. */
internal class LimitChecker(private val context: CheckContext, private val graph: CallGraph) {
    private val messages = context.messages
    private val constants = mutableSetOf<Any>()
    private val repeatedly = mutableListOf<Routine>()
    private val lists = mutableListOf<Pair<Expression.ListOf, Routine?>>()
    private var routine: Routine? = null

    fun check() {
        val tree = context.tree
        tree.statements.forEach { statement(it, isRepeated = false) }
        for (routine in tree.routines) {
            this.routine = routine
            routine.body.forEach { statement(it, isRepeated = false) }
        }
        routine = null
        for (behaviour in tree.behaviours) {
            expression(behaviour.condition, isRepeated = true)
            behaviour.body.forEach { statement(it, isRepeated = true) }
        }
        warnOfListsInRoutines()
    }

    private fun statement(statement: Statement, isRepeated: Boolean) {
        val looksEachRound =
            statement is Statement.RepeatWhile || statement is Statement.RepeatUntil || statement is Command.WaitUntil
        statement.expressions.forEach { expression(it, isRepeated || looksEachRound) }
        if (isRepeated && statement is Statement.Call) context.routineOf(statement.name)?.let(repeatedly::add)
        if (statement is Command.ShowText) count(statement.text, statement.textRange)
        statement.bodies.forEach { body -> body.forEach { statement(it, isRepeated || statement is Statement.Loop) } }
    }

    private fun expression(expression: Expression, isRepeated: Boolean) {
        expression.parts.forEach { expression(it, isRepeated) }
        when (expression) {
            is Expression.ListOf -> if (isRepeated) warnOfList(expression) else lists += expression to routine
            is Expression.Call -> if (isRepeated) context.routineOf(expression.name)?.let(repeatedly::add)
            is Expression.Number -> number(expression)
            else -> Unit
        }
    }

    private fun warnOfListsInRoutines() {
        if (lists.all { it.second == null } || context.tree.routines.size > RobolangLimits.ROUTINES) return
        val repeated = graph.repeated(repeatedly)
        for ((list, routine) in lists) {
            if (routine?.range in repeated) warnOfList(list)
        }
    }

    private fun warnOfList(list: Expression.ListOf) {
        if (BrickDialect.of(context.brick).freesLists) return
        context.warn(DiagnosticCode.LIST_IN_LOOP, list.range, messages.listInLoop())
    }

    private fun number(expression: Expression.Number) {
        val value = expression.value
        val isSmall = value is NumberValue.Whole && value.value in Short.MIN_VALUE..Short.MAX_VALUE
        if (!isSmall) count(value, expression.range)
    }

    private fun count(constant: Any, range: SourceRange) {
        if (constants.add(constant) && constants.size == RobolangLimits.CONSTANTS + 1) {
            context.report(
                DiagnosticCode.TOO_MANY_CONSTANTS,
                range,
                messages.tooManyConstants(RobolangLimits.CONSTANTS),
            )
        }
    }
}
