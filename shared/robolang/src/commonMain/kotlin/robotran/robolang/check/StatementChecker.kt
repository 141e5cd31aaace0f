package robotran.robolang.check

import robotran.robolang.Calibration
import robotran.robolang.DiagnosticCode
import robotran.robolang.RobolangLimits
import robotran.robolang.SourceFix
import robotran.robolang.run.Durations
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.shortened

/** Finds the statements whose values make no sense. */
internal class StatementChecker(
    private val context: CheckContext,
    private val expressions: ExpressionChecker,
    calibration: Calibration,
) {
    private val durations = Durations(calibration)
    private val messages = context.messages
    private var function: Draft? = null

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
            is Statement.Move -> move(statement)
            is Statement.Turn -> turn(statement)
            is Statement.Power -> power(statement.power)
            is Statement.Motor -> (statement.command as? MotorCommand.Power)?.let { power(it.power) }
            is Statement.Wait -> wait(statement)
            is Statement.WaitUntil -> expressions.needCondition(statement.condition)
            is Statement.Play -> play(statement)
            is Statement.Show -> expressions.needNumber(statement.value)
            is Statement.ShowText -> text(statement)
            is Statement.Repeat -> count(statement.count)
            is Statement.RepeatWhile -> expressions.needCondition(statement.condition)
            is Statement.RepeatUntil -> expressions.needCondition(statement.condition)
            is Statement.ForRange -> counter(statement)
            is Statement.ForEach -> expressions.needList(statement.list)
            is Statement.If -> statement.branches.forEach { expressions.needCondition(it.condition) }
            is Statement.Assign -> assign(statement)
            is Statement.Call -> call(statement)
            is Statement.Return -> statement.value?.let { value -> function?.let { expressions.needType(it.type.type, value) } }
            else -> Unit
        }
        statement.bodies.forEach { it.forEach(::check) }
    }

    private fun move(statement: Statement.Move) {
        statement.distance?.let { distance ->
            expressions.needNumber(distance)
            context.constantOf(distance)?.let { checkDuration(distance, durations.ofMove(it)) }
        }
        statement.duration?.let(::duration)
    }

    private fun turn(statement: Statement.Turn) {
        statement.angle?.let { angle ->
            expressions.needNumber(angle)
            context.constantOf(angle)?.let { checkDuration(angle, durations.ofTurn(it)) }
        }
        statement.duration?.let(::duration)
    }

    private fun duration(expression: Expression) {
        expressions.needNumber(expression)
        val value = context.constantOf(expression) ?: return
        if (value.isNegative) {
            context.report(DiagnosticCode.DURATION_NEGATIVE, expression.range, messages.durationNegative())
        } else {
            checkDuration(expression, durations.ofWait(value, TimeUnit.SECONDS))
        }
    }

    private fun wait(statement: Statement.Wait) {
        expressions.needNumber(statement.duration)
        val duration = context.constantOf(statement.duration) ?: return
        if (duration.isNegative) {
            context.report(DiagnosticCode.WAIT_NEGATIVE, statement.duration.range, messages.waitNegative())
        } else {
            checkDuration(statement.duration, durations.ofWait(duration, statement.unit))
        }
    }

    private fun checkDuration(expression: Expression, milliseconds: Int) {
        if (milliseconds > RobolangLimits.LONGEST_COMMAND_MILLISECONDS) {
            context.report(DiagnosticCode.DURATION_TOO_LONG, expression.range, messages.durationTooLong())
        }
    }

    private fun power(expression: Expression) {
        val value = context.constantOf(expression)
        if (value is NumberValue.Whole && value.value !in RobolangLimits.POWERS) {
            context.report(DiagnosticCode.POWER_OUT_OF_RANGE, expression.range, messages.powerOutOfRange())
        }
        expressions.needWhole(expression)
    }

    private fun play(statement: Statement.Play) {
        expressions.needNumber(statement.frequency)
        duration(statement.duration)
    }

    private fun text(statement: Statement.ShowText) {
        val strange = statement.text.firstOrNull { !isShown(it) }
        when {
            statement.text.length > RobolangLimits.TEXT_CHARACTERS -> {
                context.report(DiagnosticCode.TEXT_TOO_LONG, statement.textRange, messages.textTooLong(RobolangLimits.TEXT_CHARACTERS))
            }

            strange != null -> {
                context.report(DiagnosticCode.TEXT_NOT_SHOWN, statement.textRange, messages.textNotShown(strange.toString()))
            }
        }
    }

    private fun isShown(character: Char): Boolean =
        character in 'a'..'z' || character in 'A'..'Z' || character in '0'..'9' || character in " -_"

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

            else -> {
                expressions.needWhole(expression)
            }
        }
    }

    private fun counter(statement: Statement.ForRange) {
        listOfNotNull(statement.from, statement.to, statement.step).forEach(expressions::needNumber)
        val step = statement.step ?: return
        if (context.constantOf(step)?.decimal == 0f) context.report(DiagnosticCode.STEP_ZERO, step.range, messages.stepZero())
    }

    private fun assign(statement: Statement.Assign) {
        when (val target = statement.target) {
            is AssignTarget.Variable -> assignVariable(target.name, statement.value)
            is AssignTarget.Element -> assignElement(target, statement.value)
        }
    }

    private fun assignVariable(name: Name, value: Expression) {
        val draft = context.draftsByName[name.range] ?: return
        val text = shortened(name.text)
        val given = context.typeOf(value)
        val needed = draft.type.type
        when {
            draft.kind == SymbolKind.CONSTANT -> {
                context.report(DiagnosticCode.ASSIGNED_CONSTANT, name.range, messages.assignedConstant(text))
            }

            draft.kind == SymbolKind.LOOP_VARIABLE -> {
                context.report(DiagnosticCode.ASSIGNED_CONSTANT, name.range, messages.assignedLoopVariable(text))
            }

            given == ValueType.NOTHING || needed == ValueType.NOTHING || given == needed -> {
                Unit
            }

            needed == ValueType.WHOLE && given == ValueType.DECIMAL -> {
                context.report(DiagnosticCode.TYPE_CHANGED, value.range, messages.decimalForWhole(text), fixOfDeclaration(draft))
            }

            needed == ValueType.DECIMAL && given == ValueType.WHOLE -> {
                Unit
            }

            else -> {
                context.report(DiagnosticCode.TYPE_CHANGED, value.range, messages.typeChanged(text))
            }
        }
    }

    /** A variable that begins as a plain whole number can begin as a decimal one. */
    private fun fixOfDeclaration(draft: Draft): SourceFix? {
        val value = context.declaredValues[draft.name.range] as? Expression.Number ?: return null
        return SourceFix(value.range, value.text + ".0")
    }

    private fun assignElement(target: AssignTarget.Element, value: Expression) {
        val list = context.draftsByName[target.list.range] ?: return
        val type = list.type.type
        if (!type.isList && type != ValueType.NOTHING) {
            context.report(DiagnosticCode.LIST_NEEDED, target.list.range, messages.listNeeded(shortened(target.list.text)))
        }
        expressions.needElement(target.list, target.index)
        expressions.needType(type.element, value)
    }

    private fun call(statement: Statement.Call) {
        val name = statement.name
        val isFunction = BuiltIn.of(name.key) != null || context.draftsByName[name.range]?.kind == SymbolKind.FUNCTION
        if (isFunction) context.report(DiagnosticCode.FUNCTION_AS_COMMAND, name.range, messages.functionAsCommand(shortened(name.text)))
        expressions.arguments(name, statement.arguments)
    }
}
