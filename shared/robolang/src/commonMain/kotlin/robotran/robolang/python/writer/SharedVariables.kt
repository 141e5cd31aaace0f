package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.Uses
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement

/** Which variables of the whole program each part of it uses and changes. */
internal class SharedVariables(private val program: CheckedProgram, private val target: PythonTarget) {
    private val tree = program.tree

    /** Those that routines and behaviours use. */
    val ofOthers: Set<Symbol> by lazy(LazyThreadSafetyMode.NONE) {
        val uses = Uses()
        tree.routines.forEach { uses.add(it.body) }
        tree.behaviours.forEach {
            uses.add(it.condition)
            uses.add(it.body)
        }
        uses.variables.map(program::symbolOf).filter { it.isGlobal }.toSet()
    }

    /** The routines that behaviours call, directly or through others. */
    val ofBehaviours: Set<Routine> by lazy(LazyThreadSafetyMode.NONE) {
        val byKey = tree.routines.associateBy { it.name.key }
        val uses = Uses()
        tree.behaviours.forEach {
            uses.add(it.condition)
            uses.add(it.body)
        }
        val found = LinkedHashSet<Routine>()
        val waiting = ArrayDeque(uses.calls.mapNotNull { byKey[it.key] })
        while (waiting.isNotEmpty()) {
            val next = waiting.removeFirst()
            if (found.add(next)) waiting += Uses().apply { add(next.body) }.calls.mapNotNull { byKey[it.key] }
        }
        found
    }

    /** Those that [body] assigns. */
    fun changedIn(body: List<Statement>): List<Symbol> = withInner(body)
        .mapNotNull { ((it as? Statement.Assign)?.target as? AssignTarget.Variable)?.name }
        .map(program::symbolOf).filter { it.isGlobal }.distinct()

    /** The variables of the translation itself that [body] changes. */
    fun ownChangedIn(body: List<Statement>): List<String> =
        withInner(body).flatMap { target.variablesChangedBy(it) }.distinct()
}
