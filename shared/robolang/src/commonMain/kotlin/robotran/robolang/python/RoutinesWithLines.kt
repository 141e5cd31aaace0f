package robotran.robolang.python

import robotran.robolang.python.writer.withInner
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts

/**
 * The routines of a program whose lines are told while they run. Not those that a condition of `whenever` calls, which is
 * asked all the time, nor functions that only calculate: the line that calls them goes on when they are done.
 */
internal class RoutinesWithLines(private val tree: SyntaxTree) {
    private val routines = tree.routines.associateBy { it.name.key }

    val all: List<Routine>
        get() {
            val asked = calledFrom(tree.behaviours.flatMap { callsIn(it.condition) })
            return tree.routines.filter { routine -> routine !in asked && !(routine.isFunction && isQuick(routine)) }
        }

    private fun isQuick(routine: Routine): Boolean =
        calledFrom(listOf(routine.name.key)).none { called -> withInner(called.body).any(::isLong) }

    /** The routines with these [names], and those that they call, also through others. */
    private fun calledFrom(names: List<String>): Set<Routine> {
        val found = LinkedHashSet<Routine>()
        val waiting = ArrayDeque(names)
        while (waiting.isNotEmpty()) {
            val routine = routines[waiting.removeFirst()] ?: continue
            if (found.add(routine)) withInner(routine.body).forEach { waiting += callsIn(it) }
        }
        return found
    }

    private fun callsIn(statement: Statement): List<String> =
        listOfNotNull((statement as? Statement.Call)?.name?.key) + statement.expressions.flatMap(::callsIn)

    private fun callsIn(expression: Expression): List<String> =
        withParts(expression).mapNotNull { (it as? Expression.Call)?.name?.key }
}

/** Whether the program is at [statement] for a while: a drive, a wait, a sound, a text that is shown letter by letter. */
internal fun isLong(statement: Statement): Boolean = statement is Command &&
    (statement.waits || statement is Command.Beep || statement is Command.Buzz || statement is Command.ShowText)
