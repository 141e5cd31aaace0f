package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.Behaviour
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.template.fillIn

/**
 * Writes `whenever` blocks as leJOS behaviours under an arbitrator. The main program has the lowest priority. It is not
 * restarted after a behaviour but resumed, so it has a thread of its own that its behaviour suspends and resumes.
 */
internal class JavaBehaviours(
    private val program: CheckedProgram,
    private val names: JavaNames,
    private val expressions: JavaExpressions,
    private val throwing: Throwing,
    private val comments: CommentsOfItems,
    private val statements: JavaStatements,
    private val writer: JavaWriter,
    private val robot: BrickKind,
) {
    private val behaviours = program.tree.behaviours

    fun reserveNames() {
        if (behaviours.isEmpty()) return
        names.reserve(MAIN_PROGRAM)
        names.reserve(REACTIONS)
        behaviours.indices.forEach { names.reserve(className(it)) }
    }

    /** Starts the behaviours after the declarations at the start of the main program; they are evaluated first. */
    fun writeStart() {
        writer.line("mainThread = Thread.currentThread();")
        writer.line("new $REACTIONS().start();")
        writer.line("giveWay();")
    }

    fun writeClasses() {
        behaviours.forEachIndexed { index, behaviour -> write(behaviour, className(index)) }
        if (behaviours.isEmpty()) return
        val all = listOf(MAIN_PROGRAM) + behaviours.indices.map(::className)
        writer.blank()
        writer.lines(javaOf("MAIN_PROGRAM"))
        writer.blank()
        writer.lines(javaOf("REACTIONS").fillIn(mapOf("BEHAVIOURS" to all.joinToString(", ") { "new $it()" })))
    }

    private fun write(behaviour: Behaviour, name: String) {
        val line = behaviour.range.line
        writer.blank()
        writer.takeComments(comments.of(behaviour.range))
        writer.open("static class $name implements Behavior", line)
        writer.line("private boolean isActive;")
        writer.blank()
        writer.open("public boolean takeControl()")
        interruptible(throwing.mayWait(behaviour.condition), "return false;") {
            val condition = expressions.text(behaviour.condition, OperatorPrecedence.of(BinaryOperator.OR) + 1)
            writer.line("return isActive || $condition;", line)
        }
        writer.close()
        writer.blank()
        writer.open("public void action()")
        writer.line("isActive = true;")
        writer.line("actionIsSuppressed = false;")
        interruptible(throwing.mayWait(behaviour.body), "// A later behaviour has taken over.") {
            statements.block(behaviour.body)
            writer.commentsAbove(behaviour.endRange.line)
        }
        writer.line("isActive = false;")
        writer.close(behaviour.endRange.line)
        writer.blank()
        writer.lines(javaOf("SUPPRESS"))
        writer.close()
    }

    /** [content]; if [isNeeded], followed by [otherwise] for an interrupted wait. */
    private fun interruptible(isNeeded: Boolean, otherwise: String, content: () -> Unit) {
        if (!isNeeded) return content()
        writer.open("try")
        content()
        writer.reopen("catch (InterruptedException suppressed)", LineMap.NO_LINE)
        writer.line(otherwise)
        writer.close()
    }

    private fun javaOf(name: String): String = JavaTemplates.of(name, robot, isReacting = true)

    private fun className(index: Int) = "$WHENEVER${index + 1}"

    private companion object {
        const val MAIN_PROGRAM = "MainProgram"
        const val REACTIONS = "Reactions"
    }
}
