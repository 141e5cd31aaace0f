package robotran.robolang.python

import robotran.language.source.SourceRange
import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.Behaviour
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.Token
import robotran.robolang.syntax.withParts

/**
 * Writes `whenever` as tasks: for each behaviour a function with its condition and one with its lines, and the main
 * program as a task beside them.
 */
internal class PythonTasks(
    program: CheckedProgram,
    private val names: PythonNames,
    private val expressions: PythonExpressions,
    private val uses: PythonUses,
    private val commentsOf: (SourceRange) -> List<Token>,
    private val closing: List<Token>,
    private val statementsOf: (PythonWriter, PythonPlace) -> PythonStatements,
) {
    private val behaviours = program.tree.behaviours
    private val functions = mutableListOf<Pair<String, String>>()

    /** @param globals writes which variables of the whole program some lines change. */
    fun writeBehaviours(writer: PythonWriter, globals: (List<Statement>) -> Unit) {
        behaviours.forEachIndexed { index, behaviour -> write(behaviour, index + 1, writer, globals) }
    }

    private fun write(behaviour: Behaviour, number: Int, writer: PythonWriter, globals: (List<Statement>) -> Unit) {
        val about = nameOf(behaviour.condition) ?: "$number"
        val condition = names.shared("is_$about")
        val action = names.shared("when_$about")
        val line = behaviour.range.line
        functions += condition to action
        expressions.isInTask = true
        writer.gap()
        writer.takeComments(commentsOf(behaviour.range))
        writer.open("async def $condition()", line)
        writer.line("return ${expressions.text(behaviour.condition)}", line)
        writer.close()
        writer.gap()
        writer.open("async def $action()", line)
        globals(behaviour.body)
        val place = PythonPlace.Behaviour(number, number == behaviours.size, behaviour.body.firstOrNull())
        statementsOf(writer, place).write(behaviour.body)
        writer.close(behaviour.endRange.line)
        expressions.isInTask = false
    }

    private fun nameOf(condition: Expression): String? =
        when (val sense = withParts(condition).filterIsInstance<Expression.Sense>().firstOrNull()?.sense) {
            Sense.LeftBumper -> "left_bumper"
            Sense.RightBumper -> "right_bumper"
            Sense.Light -> "light"
            Sense.Timer -> "timer"
            Sense.Battery -> "battery"
            Sense.Distance -> "distance"
            Sense.Loudness -> "loudness"
            Sense.Colour -> "colour"
            is Sense.Button -> "button_${sense.button.keyword.text}"
            is Sense.Sensor -> "sensor_${sense.port}"
            is Sense.Turned -> "turned_${sense.port.name.lowercase()}"
            null -> null
        }

    /** The main program, which must not end before a `halt`, if its end is reached. */
    fun writeMain(writer: PythonWriter, statements: List<Statement>, isEndReached: Boolean) {
        expressions.isInTask = true
        names.inScope {
            statementsOf(writer, PythonPlace.MainTask(uses)).writeHere(statements) {
                writer.takeComments(commentsOf(it.range))
            }
        }
        writer.takeComments(closing)
        writer.commentsLeft()
        if (isEndReached) {
            writer.open("while True", note = "The other tasks go on.")
            writer.line("await ${uses.tool("wait")}(1000)")
            writer.close()
        }
        expressions.isInTask = false
    }

    fun writeStart(writer: PythonWriter) {
        val run = uses.tool("run_task")
        val all = uses.tool("multitask")
        val helper = uses.use(PythonHelper.WHENEVER)
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
