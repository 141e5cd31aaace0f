package robotran.runcontrol

import robotran.brick.program.VariableScope
import robotran.simulation.Session

/**
 * A variable in the UI.
 *
 * @property value in source notation.
 * @property changed whether it had another value, or none, at the last stop of the program.
 */
data class ShownVariable(val name: String, val value: String, val changed: Boolean)

/** The variables of the routine [name], or of the main program. */
data class ShownScope(val name: String, val variables: List<ShownVariable>)

/** Detects which variables have changed since the last stop of a program. */
class VariableWatch {
    private var before: Map<Place, Map<String, String>> = emptyMap()
    private var isFirst = true

    /** Call when the program of [session] continues after a stop. */
    fun willResume(session: Session) {
        before = session.threads.flatMap { thread ->
            thread.callStack.indices.take(MAX_FRAMES).flatMap { frame ->
                val depth = thread.callStack.size - frame
                session.variablesOf(thread.number, frame).mapIndexed { scope, known ->
                    Place(thread.number, depth, scope, known.name) to known.values()
                }
            }
        }.toMap()
        isFirst = false
    }

    /** Clears all values, such as when another program starts. */
    fun forget() {
        before = emptyMap()
        isFirst = true
    }

    /** The variables visible in [frame] of the call stack of the thread with the number [thread], its own first. */
    fun update(session: Session, thread: Int, frame: Int): List<ShownScope> {
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
     * A scope that is visible in a routine.
     *
     * @property depth the position of its frame from the bottom of the call stack.
     * @property scope its index among the routine's visible scopes.
     */
    private data class Place(val thread: Int, val depth: Int, val scope: Int, val name: String)

    private companion object {
        /** Number of innermost frames of each thread whose values are stored. */
        const val MAX_FRAMES = 50
    }
}
