package robotran.robolang.python.microbit

import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.withInner
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts

/** Tells whether a program calls itself deeper than its board can. */
internal class DeepCallNotes(private val robot: RobotTarget.Microbit, private val context: PythonContext) {
    private val tree = context.tree
    private val notes = context.notes
    private val messages = notes.messages

    fun tell() {
        val routine = tree.routines.firstOrNull { callsItself(it) } ?: return
        notes.tell(routine.range, messages.deepCalls("${BoardRoom.deepestCallsOn(robot.model)}"))
    }

    private fun callsItself(routine: Routine): Boolean {
        val seen = mutableSetOf<String>()
        val waiting = ArrayDeque(calledBy(routine))
        while (waiting.isNotEmpty()) {
            val next = waiting.removeFirst()
            if (next == routine.name.key) return true
            if (seen.add(next)) tree.routines.firstOrNull { it.name.key == next }?.let { waiting += calledBy(it) }
        }
        return false
    }

    private fun calledBy(routine: Routine): List<String> = withInner(routine.body).flatMap { statement ->
        listOfNotNull((statement as? Statement.Call)?.name?.key) +
            statement.expressions.flatMap(::withParts).mapNotNull { (it as? Expression.Call)?.name?.key }
    }
}
