package robotran.robolang.nqc

import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts

/** The routines that call themselves, directly or through others; NQC puts each call's whole body in. */
internal class RecursiveRoutines(private val program: CheckedProgram) {
    private val routines = program.tree.routines
    private val bySymbol = routines.associateBy { program.symbolOf(it.name) }
    private val called: Map<Routine, Set<Routine>> =
        routines.associateWith { routine -> routine.body.flatMap { callsIn(it) }.mapNotNull { routineOf(it) }.toSet() }
    private val recursive: Set<Routine> = routines.filter { it in reached(it) }.toSet()

    operator fun contains(routine: Routine): Boolean = routine in recursive

    fun isCalledBy(name: Name): Boolean = routineOf(name)?.let { it in recursive } ?: false

    private fun routineOf(name: Name): Routine? = bySymbol[program.symbolOf(name)]

    private fun callsIn(statement: Statement): List<Name> {
        val own = statement.expressions.flatMap { withParts(it) }.filterIsInstance<Expression.Call>().map { it.name }
        return own + listOfNotNull((statement as? Statement.Call)?.name) +
            statement.bodies.flatten().flatMap { callsIn(it) }
    }

    private fun reached(from: Routine): Set<Routine> {
        val reached = LinkedHashSet<Routine>()
        val waiting = ArrayDeque(called.getValue(from))
        while (waiting.isNotEmpty()) {
            val next = waiting.removeFirst()
            if (reached.add(next)) waiting += called.getValue(next)
        }
        return reached
    }
}
