package robotran.robolang.python.microbit

import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonParts
import robotran.robolang.python.writer.PythonPlace
import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.python.writer.nameOfCondition
import robotran.robolang.syntax.Behaviour
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.leadingDeclarations
import robotran.robolang.translate.JavaFlow

/**
 * Writes `whenever`: for each behaviour a function with its condition and one with its lines. The main program looks at
 * the conditions itself, whenever time goes by or what they depend on changes.
 */
internal class MicrobitReactions(
    private val context: PythonContext,
    private val parts: PythonParts,
    private val watched: WatchedVariables,
) {
    private val names = context.names
    private val tree = context.tree
    private val functions = mutableListOf<Pair<String, String>>()

    fun writeBehaviours(writer: PythonWriter) {
        tree.behaviours.forEachIndexed { index, behaviour -> write(behaviour, index + 1, writer) }
    }

    private fun write(behaviour: Behaviour, number: Int, writer: PythonWriter) {
        val about = nameOfCondition(behaviour.condition) ?: "$number"
        val condition = names.shared("is_$about")
        val action = names.shared("when_$about")
        val line = behaviour.range.line
        functions += condition to action
        writer.gap()
        writer.takeComments(parts.commentsOf(behaviour.range))
        writer.open("def $condition()", line)
        writer.line("return ${context.expressions.text(behaviour.condition)}", line)
        writer.close()
        writer.gap()
        writer.open("def $action()", line)
        parts.globals(behaviour.body, writer)
        parts.statements(writer, PythonPlace.Plain()).write(behaviour.body)
        writer.close(behaviour.endRange.line)
    }

    /** Writes the list of all, a later one goes first. */
    fun writeList(main: PythonWriter) {
        main.line("behaviours = (")
        main.enter()
        for ((condition, action) in functions) main.line("($condition, $action),")
        main.leave()
        main.line(")")
    }

    /** The main program, which goes on for its behaviours if it ends. */
    fun writeMain(main: PythonWriter) = names.inScope {
        val statements = parts.statements(main, PythonPlace.Plain())
        val rest = parts.statements
        val first = tree.leadingDeclarations.count { it in rest }

        fun write(part: List<Statement>) = statements.writeHere(part) { main.takeComments(parts.commentsOf(it.range)) }
        write(rest.take(first))
        if (watched.isCalledEarly) main.line("acting = 0")
        main.line("${context.uses.use(MicrobitHelper.LOOK)}()")
        write(rest.drop(first))
        main.takeComments(parts.closing)
        main.commentsLeft()
        if (!JavaFlow(context.program).completes(rest) || rest.lastOrNull() is Statement.Halt) return@inScope
        main.open("while True", note = "The behaviours go on.")
        main.line("${context.uses.use(MicrobitHelper.TICK)}()")
        main.close()
    }
}
