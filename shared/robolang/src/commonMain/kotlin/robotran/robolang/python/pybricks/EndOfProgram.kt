package robotran.robolang.python.pybricks

import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.python.writer.withInner
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.Statement

/** What stands behind a main program whose end is reached: there all motors of a hub roll on. */
internal class EndOfProgram(
    private val statements: List<Statement>,
    private val mayTurn: Boolean,
    private val hasPen: Boolean,
    private val commands: PybricksCommands,
) {
    fun write(writer: PythonWriter) {
        if (statements.lastOrNull() is Statement.Halt) return
        if (mayTurn && !stands()) {
            commands.stop().forEach { writer.line(it) }
        } else if (hasPen && isDrawing()) {
            writer.line(commands.wait("$STANDING"), note = "Until the robot stands.")
        }
    }

    /** Whether the last thing that moves the robot is a `stop` of the main program itself. */
    private fun stands(): Boolean =
        statements.lastOrNull { withInner(listOf(it)).any(::mayMove) } is Command.StopDriving

    private fun mayMove(statement: Statement): Boolean = when (statement) {
        is Statement.Call, is Command.StopDriving -> true
        is Command -> statement.moves
        else -> false
    }

    /** Whether the last thing that is done is a drive with the pen down. */
    private fun isDrawing(): Boolean {
        val all = withInner(statements).filterIsInstance<Command>()
        val lastPen = all.lastOrNull { it is Command.Pen } as? Command.Pen
        val last = all.lastOrNull { it is Command.Pen || it.moves || it is Command.Wait }
        return lastPen?.position == PenPosition.DOWN && (last is Command.Move || last is Command.Turn)
    }

    private companion object {
        /** How long a robot needs to stand still, in milliseconds. */
        const val STANDING = 200
    }
}
