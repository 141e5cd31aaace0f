package robotran.robolang.check

import robotran.brick.kind.BrickKind
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.MotorCommand
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.TimeUnit
import robotran.robolang.syntax.expressions

/** Finds commands with invalid values. */
internal class CommandChecker(
    private val context: CheckContext,
    private val expressions: ExpressionChecker,
    private val robot: RobotTarget,
) {
    private val durations = Durations(robot)
    private val messages = context.messages

    fun check(command: Command) {
        when (command) {
            is Command.Move -> move(command)
            is Command.Turn -> turn(command)
            is Command.Power -> power(command.power)
            is Command.MotorTurn -> expressions.needNumber(command.angle)
            is Command.Motor -> (command.command as? MotorCommand.Power)?.let { power(it.power) }
            is Command.Wait -> wait(command)
            is Command.WaitUntil -> expressions.needCondition(command.condition)
            is Command.Play -> play(command)
            is Command.Show -> expressions.needShown(command.value)
            is Command.ShowText -> text(command)
            is Command.StartMoving, is Command.StartTurning, is Command.StopDriving, is Command.ResetMotor,
            is Command.Pen, is Command.ResetTimer, is Command.Beep, is Command.Buzz, is Command.ClearScreen,
            -> Unit
        }
    }

    private fun move(statement: Command.Move) {
        statement.distance?.let { distance ->
            expressions.needNumber(distance)
            context.constantOf(distance)?.let { checkDuration(distance, durations.ofMove(it)) }
        }
        statement.duration?.let(::duration)
    }

    private fun turn(statement: Command.Turn) {
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

    private fun wait(statement: Command.Wait) {
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

    private fun play(statement: Command.Play) {
        expressions.needNumber(statement.frequency)
        duration(statement.duration)
    }

    private fun text(statement: Command.ShowText) {
        val isNxt = robot.kind == BrickKind.NXT
        val limit = if (isNxt) RobolangLimits.NXT_TEXT_CHARACTERS else RobolangLimits.TEXT_CHARACTERS
        val strange = statement.text.firstOrNull { if (isNxt) it !in ' '..'~' else !isShown(it) }
        when {
            statement.text.length > limit -> {
                context.report(DiagnosticCode.TEXT_TOO_LONG, statement.textRange, messages.textTooLong(limit))
            }

            strange != null -> {
                val character = strange.toString()
                val message = if (isNxt) messages.textNotShownOnNxt(character) else messages.textNotShown(character)
                context.report(DiagnosticCode.TEXT_NOT_SHOWN, statement.textRange, message)
            }
        }
    }

    private fun isShown(character: Char): Boolean =
        character in 'a'..'z' || character in 'A'..'Z' || character in '0'..'9' || character in " -_"
}
