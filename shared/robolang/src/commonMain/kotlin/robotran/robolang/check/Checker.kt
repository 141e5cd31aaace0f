package robotran.robolang.check

import robotran.robolang.Calibration
import robotran.robolang.DiagnosticCode
import robotran.robolang.Mistakes
import robotran.robolang.RobolangLimits
import robotran.robolang.run.Durations
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.shortened

/** Finds what is well written but cannot be done. */
internal class Checker(
    calibration: Calibration,
    private val mistakes: Mistakes,
) {
    private val durations = Durations(calibration)
    private val messages = mistakes.messages

    fun check(tree: SyntaxTree): CheckedProgram {
        tree.statements.forEach(::check)
        return CheckedProgram(tree, emptyList(), emptyMap(), emptyMap())
    }

    private fun check(statement: Statement) {
        when (statement) {
            is Statement.Move -> statement.distance?.let { checkDuration(it, durations.ofMove(value(it))) }
            is Statement.Turn -> statement.angle?.let { checkDuration(it, durations.ofTurn(value(it))) }
            is Statement.Wait -> checkWait(statement)
            is Statement.Repeat -> checkRepeat(statement)
            else -> Unit
        }
    }

    private fun checkWait(statement: Statement.Wait) {
        val duration = value(statement.duration)
        if (duration.isNegative) {
            report(DiagnosticCode.WAIT_NEGATIVE, statement.duration, messages.waitNegative())
        } else {
            checkDuration(statement.duration, durations.ofWait(duration, statement.unit))
        }
    }

    private fun checkRepeat(statement: Statement.Repeat) {
        val count = value(statement.count)
        val text = shortened(textOf(statement.count))
        when {
            count is NumberValue.Decimal -> report(DiagnosticCode.COUNT_NOT_WHOLE, statement.count, messages.countNotWhole(text))
            count.isNegative -> report(DiagnosticCode.COUNT_NEGATIVE, statement.count, messages.countNegative(text))
        }
        statement.body.forEach(::check)
    }

    private fun checkDuration(expression: Expression, milliseconds: Int) {
        if (milliseconds > RobolangLimits.LONGEST_COMMAND_MILLISECONDS) {
            report(DiagnosticCode.DURATION_TOO_LONG, expression, messages.durationTooLong())
        }
    }

    private fun report(code: DiagnosticCode, expression: Expression, message: String) {
        mistakes.report(code, expression.range, textOf(expression), message)
    }

    private fun value(expression: Expression): NumberValue = when (expression) {
        is Expression.Number -> expression.value
        else -> error("The parser makes numbers only.")
    }

    private fun textOf(expression: Expression): String = when (expression) {
        is Expression.Number -> expression.text
        else -> error("The parser makes numbers only.")
    }
}
