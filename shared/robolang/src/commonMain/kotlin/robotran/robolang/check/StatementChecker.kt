package robotran.robolang.check

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.shortened

/** Finds statements with invalid values. */
internal class StatementChecker(
    private val context: CheckContext,
    private val expressions: ExpressionChecker,
    robot: RobotTarget,
) {
    private val commands = CommandChecker(context, expressions, robot)
    private val assignments = AssignmentChecker(context, expressions)
    private val messages = context.messages
    private var function: UnresolvedSymbol? = null

    fun check() {
        context.tree.statements.forEach(::check)
        for (routine in context.tree.routines) {
            function = context.draftsByName[routine.name.range]
            routine.body.forEach(::check)
        }
        function = null
        for (behaviour in context.tree.behaviours) {
            expressions.check(behaviour.condition)
            expressions.needCondition(behaviour.condition)
            behaviour.body.forEach(::check)
        }
    }

    private fun check(statement: Statement) {
        statement.expressions.forEach(expressions::check)
        when (statement) {
            is Command -> commands.check(statement)
            is Statement.Repeat -> count(statement.count)
            is Statement.RepeatWhile -> expressions.needCondition(statement.condition)
            is Statement.RepeatUntil -> expressions.needCondition(statement.condition)
            is Statement.ForRange -> counter(statement)
            is Statement.ForEach -> expressions.needList(statement.list)
            is Statement.If -> statement.branches.forEach { expressions.needCondition(it.condition) }
            is Statement.Assign -> assignments.check(statement)
            is Statement.Call -> call(statement)

            is Statement.Return -> statement.value?.let { value ->
                function?.let { expressions.needType(it.type.type, value) }
            }

            is Statement.RepeatForever, is Statement.Break, is Statement.Continue, is Statement.Declare,
            is Statement.Halt,
            -> Unit
        }
        statement.bodies.forEach { it.forEach(::check) }
    }

    private fun count(expression: Expression) {
        val count = context.constantOf(expression)
        val text = context.quotable(expression)
        when {
            count is NumberValue.Decimal -> {
                context.report(DiagnosticCode.COUNT_NOT_WHOLE, expression.range, messages.countNotWhole(text))
            }

            count?.isNegative == true -> {
                context.report(DiagnosticCode.COUNT_NEGATIVE, expression.range, messages.countNegative(text))
            }

            else -> expressions.needWhole(expression)
        }
    }

    private fun counter(statement: Statement.ForRange) {
        listOfNotNull(statement.from, statement.to, statement.step).forEach(expressions::needNumber)
        val step = statement.step ?: return
        if (context.constantOf(step)?.decimal == 0f) {
            context.report(DiagnosticCode.STEP_ZERO, step.range, messages.stepZero())
        }
    }

    private fun call(statement: Statement.Call) {
        val name = statement.name
        val isFunction = BuiltIn.of(name.key) != null || context.draftsByName[name.range]?.kind == SymbolKind.FUNCTION
        if (isFunction) {
            context.report(
                DiagnosticCode.FUNCTION_AS_COMMAND,
                name.range,
                messages.functionAsCommand(shortened(name.text)),
            )
        }
        expressions.arguments(name, statement.arguments)
    }
}
