package robotran.robolang.check

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.words.BrickDialect
import robotran.robolang.words.ValueUse

/** Finds commands with invalid values. */
internal class CommandChecker(
    private val context: CheckContext,
    private val expressions: ExpressionChecker,
    private val robot: RobotTarget,
) {
    private val durations = Durations(robot)
    private val messages = context.messages

    fun check(command: Command) {
        command.values.forEach { (value, use) -> check(value, use, command) }
        if (command is Command.ShowText) text(command)
    }

    private fun check(value: Expression, use: ValueUse, command: Command) {
        when (use) {
            ValueUse.DISTANCE -> measure(value, durations::ofMove)
            ValueUse.ANGLE -> if (command is Command.Turn) {
                measure(
                    value,
                    durations::ofTurn,
                )
            } else {
                expressions.needNumber(value)
            }
            ValueUse.SECONDS -> duration(value, TimeUnit.SECONDS, command)
            ValueUse.MILLISECONDS -> duration(value, TimeUnit.MILLISECONDS, command)
            ValueUse.POWER -> power(value)
            ValueUse.SHOWN -> expressions.needShown(value)
            ValueUse.CONDITION -> expressions.needCondition(value)
            ValueUse.LIST -> expressions.needList(value)
            ValueUse.COUNT, ValueUse.INDEX -> expressions.needWhole(value)
            ValueUse.FREQUENCY, ValueUse.NUMBER -> expressions.needNumber(value)
            ValueUse.ANY -> Unit
        }
    }

    private fun measure(value: Expression, milliseconds: (NumberValue) -> Int) {
        expressions.needNumber(value)
        context.constantOf(value)?.let { checkDuration(value, milliseconds(it)) }
    }

    private fun duration(expression: Expression, unit: TimeUnit, command: Command) {
        expressions.needNumber(expression)
        val value = context.constantOf(expression) ?: return
        when {
            !value.isNegative -> checkDuration(expression, durations.ofWait(value, unit))

            command is Command.Wait -> {
                context.report(DiagnosticCode.WAIT_NEGATIVE, expression.range, messages.waitNegative())
            }

            else -> context.report(DiagnosticCode.DURATION_NEGATIVE, expression.range, messages.durationNegative())
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

    private fun text(statement: Command.ShowText) {
        val dialect = BrickDialect.of(robot.kind)
        val limit = dialect.textLength
        val strange = statement.text.firstOrNull { !dialect.shows(it) }
        when {
            statement.text.length > limit -> {
                context.report(DiagnosticCode.TEXT_TOO_LONG, statement.textRange, messages.textTooLong(limit))
            }

            strange != null -> {
                val character = strange.toString()
                val message =
                    if (dialect.showsAscii) messages.textNotShownOnNxt(character) else messages.textNotShown(character)
                context.report(DiagnosticCode.TEXT_NOT_SHOWN, statement.textRange, message)
            }
        }
    }
}
