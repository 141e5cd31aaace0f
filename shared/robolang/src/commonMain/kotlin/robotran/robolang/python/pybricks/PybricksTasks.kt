package robotran.robolang.python.pybricks

import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonParts
import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.python.writer.nameOfCondition
import robotran.robolang.syntax.Behaviour
import robotran.robolang.syntax.Statement

/**
 * Writes `whenever` as tasks: for each behaviour a function with its condition and one with its lines, and the main
 * program as a task beside them.
 */
internal class PybricksTasks(
    private val context: PythonContext,
    private val awaiting: PybricksAwaiting,
    private val parts: PythonParts,
) {
    private val names = context.names
    private val uses = context.uses
    private val behaviours = context.tree.behaviours
    private val functions = mutableListOf<Pair<String, String>>()

    fun writeBehaviours(writer: PythonWriter) =
        behaviours.forEachIndexed { index, behaviour -> write(behaviour, index + 1, writer) }

    private fun write(behaviour: Behaviour, number: Int, writer: PythonWriter) {
        val about = nameOfCondition(behaviour.condition) ?: "$number"
        val condition = names.shared("is_$about")
        val action = names.shared("when_$about")
        val line = behaviour.range.line
        functions += condition to action
        awaiting.isInTask = true
        writer.gap()
        writer.takeComments(parts.commentsOf(behaviour.range))
        writer.open("async def $condition()", line)
        writer.line("return ${context.expressions.text(behaviour.condition)}", line)
        writer.close()
        writer.gap()
        writer.open("async def $action()", line)
        parts.globals(behaviour.body, writer)
        val place = BehaviourPlace(number, number == behaviours.size, behaviour.body.firstOrNull())
        parts.statements(writer, place).write(behaviour.body)
        writer.close(behaviour.endRange.line)
        awaiting.isInTask = false
    }

    /** The main program, which must not end before a `halt`, if its end is reached. */
    fun writeMain(writer: PythonWriter, statements: List<Statement>, isEndReached: Boolean) {
        awaiting.isInTask = true
        names.inScope {
            parts.statements(writer, MainTaskPlace(uses)).writeHere(statements) {
                writer.takeComments(parts.commentsOf(it.range))
            }
        }
        writer.takeComments(parts.closing)
        writer.commentsLeft()
        if (isEndReached) {
            writer.open("while True", note = "The other tasks go on.")
            writer.line("await ${uses.tool("wait")}(1000)")
            writer.close()
        }
        awaiting.isInTask = false
    }

    fun writeStart(writer: PythonWriter) {
        val run = uses.tool("run_task")
        val all = uses.tool("multitask")
        val helper = uses.use(PybricksHelper.WHENEVER)
        val tasks = functions.mapIndexed { index, (condition, action) -> "$helper(${index + 1}, $condition, $action)" }
        writer.line("$run(")
        writer.enter()
        writer.line("$all(")
        writer.enter()
        // Conditions are looked at before the main program goes on, the last one first.
        (tasks.reversed() + "main()").forEach { writer.line("$it,") }
        writer.line("race=True,")
        writer.leave()
        writer.line(")")
        writer.leave()
        writer.line(")")
    }
}
