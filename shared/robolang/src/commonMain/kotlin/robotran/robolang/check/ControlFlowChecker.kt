package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts
import robotran.robolang.syntax.shortened

/** Checks the control flow: misplaced jumps, unreachable code and idle loops. */
internal class ControlFlowChecker(private val context: CheckContext) {
    private val messages = context.messages
    private var routine: Routine? = null

    /** For each open loop, whether a `break` leaves it. */
    private val left = ArrayDeque<Boolean>()

    fun check() {
        goesOn(context.tree.statements)
        context.tree.behaviours.forEach { goesOn(it.body) }
        for (routine in context.tree.routines) {
            this.routine = routine
            val comesToItsEnd = goesOn(routine.body)
            if (routine.isFunction && comesToItsEnd && !isDamaged(routine)) reportMissingReturn(routine)
        }
    }

    private fun isDamaged(routine: Routine): Boolean =
        context.parsed.isUncertain || context.errorLines.any { it in routine.range.line..routine.endRange.line }

    private fun reportMissingReturn(routine: Routine) {
        val message = messages.missingReturn(shortened(routine.name.text))
        context.report(DiagnosticCode.MISSING_RETURN, routine.name.range, message)
    }

    /** Whether the end of [statements] is reachable. */
    private fun goesOn(statements: List<Statement>): Boolean {
        var stopper: Statement? = null
        var isReported = false
        for (statement in statements) {
            if (stopper != null && !isReported) {
                isReported = true
                val word = context.textOf(stopper.range).takeWhile { it.isLetter() }
                context.warn(DiagnosticCode.NEVER_REACHED, statement.range, messages.neverReached(word))
            }
            if (!goesOn(statement) && stopper == null) stopper = statement
        }
        return stopper == null
    }

    private fun goesOn(statement: Statement): Boolean = when (statement) {
        is Statement.Break, is Statement.Continue -> leaveRound(statement)
        is Statement.Return -> leaveRoutine(statement)
        is Statement.Halt -> false
        is Statement.If -> goesOnBehindChoice(statement)
        is Statement.Loop -> goesOnBehindLoop(statement)
        is Command, is Statement.Declare, is Statement.Assign, is Statement.Call -> true
    }

    private fun goesOnBehindChoice(statement: Statement.If): Boolean {
        val branches = statement.bodies.map { goesOn(it) }
        return statement.otherwise == null || branches.any { it }
    }

    private fun goesOnBehindLoop(statement: Statement.Loop): Boolean {
        left.addLast(false)
        goesOn(statement.body)
        val isLeft = left.removeLast()
        if (statement !is Statement.RepeatForever) return true
        if (!isLeft && !BlockingLoops.isRestful(statement.body)) warnOfBusyLoop(statement)
        return isLeft
    }

    private fun warnOfBusyLoop(statement: Statement.RepeatForever) {
        context.warn(DiagnosticCode.BUSY_LOOP, statement.range, messages.busyLoop())
    }

    private fun leaveRound(statement: Statement): Boolean {
        if (left.isEmpty()) {
            val word = context.textOf(statement.range)
            if (!context.parsed.isUncertain) {
                context.report(
                    DiagnosticCode.OUTSIDE_LOOP,
                    statement.range,
                    messages.outsideLoop(word),
                )
            }
        } else if (statement is Statement.Break) {
            left[left.lastIndex] = true
        }
        return false
    }

    private fun leaveRoutine(statement: Statement.Return): Boolean {
        val routine = routine
        val value = statement.value
        if (routine == null) {
            if (!context.parsed.isUncertain) {
                context.report(
                    DiagnosticCode.OUTSIDE_ROUTINE,
                    statement.range,
                    messages.outsideRoutine(),
                )
            }
        } else if (routine.isFunction && value == null) {
            report(
                statement.range,
                DiagnosticCode.RETURN_WITHOUT_VALUE,
                messages.returnWithoutValue(shortened(routine.name.text)),
            )
        } else if (!routine.isFunction && value != null) {
            report(
                value.range,
                DiagnosticCode.RETURN_WITH_VALUE,
                messages.returnWithValue(shortened(routine.name.text)),
            )
        }
        return false
    }

    private fun report(range: SourceRange, code: DiagnosticCode, message: String) {
        if (!context.parsed.isUncertain) context.report(code, range, message)
    }
}

/** Whether a loop takes time, reads a sensor or ends. */
private object BlockingLoops {
    fun isRestful(statements: List<Statement>): Boolean = statements.any(::isRestful)

    private fun isRestful(statement: Statement): Boolean = when (statement) {
        is Command -> statement.moves || (statement.waits && statement !is Command.Play)
        is Statement.Call, is Statement.Halt, is Statement.Return -> true

        is Statement.Block, is Statement.Break, is Statement.Continue, is Statement.Declare,
        is Statement.Assign,
        -> false
    } || statement.expressions.any(::isSensing) || statement.bodies.any(::isRestful)

    /** Whether [expression] reads a sensor, or calls a routine, which may read one. */
    private fun isSensing(expression: Expression): Boolean =
        expression is Expression.Sense || (expression is Expression.Call && BuiltIn.of(expression.name.key) == null) ||
            expression.parts.any(::isSensing)
}
