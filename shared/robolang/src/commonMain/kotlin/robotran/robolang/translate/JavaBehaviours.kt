package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.Behaviour

/** Writes the `whenever` blocks, and the main program with them, as leJOS behaviours under an arbitrator. */
internal class JavaBehaviours(
    private val program: CheckedProgram,
    private val names: JavaNames,
    private val expressions: JavaExpressions,
    private val throwing: Throwing,
    private val comments: CommentsOfItems,
    private val statements: JavaStatements,
    private val writer: JavaWriter,
) {
    private val behaviours = program.tree.behaviours

    fun reserveNames() {
        if (behaviours.isEmpty()) return
        names.reserve(MAIN_PROGRAM)
        behaviours.indices.forEach { names.reserve(className(it)) }
    }

    fun writeStart() {
        val all = listOf(MAIN_PROGRAM) + behaviours.indices.map(::className)
        writer.line("Behavior[] behaviours = {${all.joinToString(", ") { "new $it()" }}};")
        writer.line("new Arbitrator(behaviours).start();")
    }

    fun writeMainProgram(body: () -> Unit) {
        behaviourClass(MAIN_PROGRAM, "true", throwing.mayWait(program.tree.statements), LineMap.NO_LINE, LineMap.NO_LINE, body)
    }

    fun writeClasses() = behaviours.forEachIndexed { index, behaviour -> write(behaviour, className(index)) }

    private fun write(behaviour: Behaviour, name: String) {
        writer.takeComments(comments.of(behaviour.range))
        val condition = expressions.text(behaviour.condition)
        behaviourClass(name, condition, throwing.mayWait(behaviour.body), behaviour.range.line, behaviour.endRange.line) {
            statements.block(behaviour.body)
            writer.commentsAbove(behaviour.endRange.line)
        }
    }

    private fun behaviourClass(name: String, condition: String, mayWait: Boolean, line: Int, endLine: Int, body: () -> Unit) {
        writer.blank()
        writer.open("static class $name implements Behavior", line)
        writer.line("private Thread runner;")
        writer.blank()
        writer.open("public boolean takeControl()")
        writer.line("return $condition;", line)
        writer.close()
        writer.blank()
        writer.open("public void action()")
        writer.line("runner = Thread.currentThread();")
        if (mayWait) {
            writer.open("try")
            body()
            writer.reopen("catch (InterruptedException suppressed)", LineMap.NO_LINE)
            writer.line("Motor.A.stop();")
            writer.line("Motor.C.stop();")
            writer.close()
        } else {
            body()
        }
        writer.close(endLine)
        writer.blank()
        writer.open("public void suppress()")
        writer.line("if (runner != null) runner.interrupt();")
        writer.close()
        writer.close()
    }

    private fun className(index: Int) = "Whenever${index + 1}"

    private companion object {
        const val MAIN_PROGRAM = "MainProgram"
    }
}
