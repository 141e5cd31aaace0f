package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts

/** Finds the routines that may wait: in Java they and their callers declare `throws InterruptedException`. */
internal class Throwing(
    private val program: CheckedProgram,
    private val waitsForStop: Boolean,
    private val stopsAtEnd: Boolean,
) {
    private val waiting: Set<Symbol> = routinesThatWait()

    fun mayWait(routine: Routine): Boolean = program.symbolOf(routine.name) in waiting

    fun mayWait(statements: List<Statement>): Boolean = waits(statements, waiting)

    fun mayWait(expression: Expression): Boolean = called(expression).any { it in waiting }

    private fun routinesThatWait(): Set<Symbol> {
        val found = mutableSetOf<Symbol>()
        do {
            val before = found.size
            program.tree.routines.filter { waits(it.body, found) }.mapTo(found) { program.symbolOf(it.name) }
        } while (found.size > before)
        return found
    }

    private fun waits(statements: List<Statement>, known: Set<Symbol>): Boolean = statements.any { statement ->
        waitsItself(statement) ||
            called(statement).any { it in known } ||
            statement.bodies.any { waits(it, known) }
    }

    private fun waitsItself(statement: Statement): Boolean = when (statement) {
        is Command -> statement.waits || (statement is Command.StopDriving && waitsForStop)
        is Statement.Loop -> program.tree.behaviours.isNotEmpty()
        is Statement.Halt -> stopsAtEnd
        is Statement.If, is Statement.Break, is Statement.Continue, is Statement.Declare, is Statement.Assign,
        is Statement.Call, is Statement.Return,
        -> false
    }

    private fun called(statement: Statement): Set<Symbol> {
        val own = (statement as? Statement.Call)?.let { setOf(program.symbolOf(it.name)) }.orEmpty()
        return own + statement.expressions.flatMap(::called)
    }

    private fun called(expression: Expression): List<Symbol> =
        withParts(expression).filterIsInstance<Expression.Call>().map { program.symbolOf(it.name) }
}
