package robotran.robolang.python.pybricks

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.python.writer.withInner
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts

/**
 * The routines that take time: in a program with tasks they are `async`, and each call of them is awaited. That goes
 * from each to those that call it.
 *
 * @param isReadingAwaited whether a reading takes time.
 */
internal class AwaitedRoutines(private val program: CheckedProgram, private val isReadingAwaited: (Sense) -> Boolean) {
    private val awaited: Set<Symbol> = if (program.tree.behaviours.isEmpty()) emptySet() else routinesThatWait()

    operator fun contains(routine: Symbol): Boolean = routine in awaited

    fun takesTime(expression: Expression): Boolean = takesTime(expression, awaited)

    private fun routinesThatWait(): Set<Symbol> {
        val found = HashSet<Symbol>()
        do {
            val before = found.size
            for (routine in program.tree.routines) {
                if (withInner(routine.body).any { takesTime(it, found) }) found += program.symbolOf(routine.name)
            }
        } while (found.size > before)
        return found
    }

    private fun takesTime(statement: Statement, known: Set<Symbol>): Boolean = statement is Command ||
        statement is Statement.RepeatForever ||
        (statement as? Statement.Call)?.let { program.symbolOf(it.name) in known } == true ||
        statement.expressions.any { takesTime(it, known) }

    private fun takesTime(expression: Expression, known: Set<Symbol>): Boolean = withParts(expression).any {
        when (it) {
            is Expression.Call -> program.symbolOf(it.name) in known
            is Expression.Sense -> isReadingAwaited(it.sense)
            else -> false
        }
    }
}
