package robotran.runcontrol

import robotran.rcxrom.program.VariableScope
import robotran.simulation.Session

/**
 * A variable as it is shown.
 *
 * @property value as the program would write it down.
 * @property changed whether it has had another value, or none, when the program was stopped the last time.
 */
data class ShownVariable(val name: String, val value: String, val changed: Boolean)

/** The variables of a routine, or of the main program, called [name]. */
data class ShownScope(val name: String, val variables: List<ShownVariable>)

/** Tells which variables have changed since a program was stopped the last time. */
class VariableWatch {
    private var before: Map<Place, Map<String, String>> = emptyMap()
    private var isFirst = true

    /** The program of [session] goes on from where it was stopped. */
    fun goesOn(session: Session) {
        before = session.threads.flatMap { thread ->
            thread.callStack.indices.take(DEEPEST).flatMap { frame ->
                val depth = thread.callStack.size - frame
                session.variablesOf(thread.number, frame).mapIndexed { scope, known ->
                    Place(thread.number, depth, scope, known.name) to known.values()
                }
            }
        }.toMap()
        isFirst = false
    }

    /** Nothing is known of the program, as when another is run. */
    fun forget() {
        before = emptyMap()
        isFirst = true
    }

    /** What the place [frame] in the call stack of the thread numbered [thread] knows, its own first. */
    fun look(session: Session, thread: Int, frame: Int): List<ShownScope> {
        val lookedAt = session.threads.find { it.number == thread } ?: return emptyList()
        val depth = lookedAt.callStack.size - frame
        return session.variablesOf(thread, frame).mapIndexed { scope, known ->
            val then = before[Place(thread, depth, scope, known.name)].orEmpty()
            ShownScope(
                known.name,
                known.variables.map {
                    ShownVariable(
                        it.name,
                        it.value,
                        !isFirst && then[it.name] != it.value,
                    )
                },
            )
        }
    }

    private fun VariableScope.values() = variables.associate { it.name to it.value }

    /**
     * A scope that a routine knows.
     *
     * @property depth how many routines have been called to come to it.
     * @property scope its place among those that the routine knows.
     */
    private data class Place(val thread: Int, val depth: Int, val scope: Int, val name: String)

    private companion object {
        /** How many of the innermost routines of each thread are remembered. */
        const val DEEPEST = 50
    }
}
