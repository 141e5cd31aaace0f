package robotran.simulation

import robotran.brick.program.DebugStatement
import robotran.brick.program.DebuggableRun
import robotran.brick.program.StatementWatch
import robotran.brick.program.StepKind
import robotran.brick.program.ThreadActivity

/**
 * Stops [run] at breakpoints and after a requested [step]. The statement before which the run stands at creation
 * belongs to the step.
 *
 * @param robot the index of the robot that runs it.
 * @param isPaused whether the run was stopped before that statement, so that it does not query it again.
 * @param chosen the number of the thread that steps, however long it waits; null for the current one.
 */
internal class Stepping(
    private val robot: Int,
    val run: DebuggableRun,
    private val breakpoints: Set<Breakpoint>,
    private val step: StepKind? = null,
    isPaused: Boolean = false,
    chosen: Int? = null,
) : StatementWatch {
    private val threads = run.threads
    private val isChosen = threads.any { it.number == chosen }
    private val thread = threads.find { if (isChosen) it.number == chosen else it.isCurrent }
    private val depth = thread?.callStack.orEmpty().size - 1
    private var asksOfOwnStatement =
        step != null && thread != null && run.isBeforeStatement(thread.number) && !(isPaused && thread.isCurrent)

    val canStop: Boolean get() = step != null || breakpoints.isNotEmpty()

    /** Why the run stopped, null if it has not. */
    var reason: StopReason? = null
        private set

    override fun pausesBefore(statement: DebugStatement): Boolean {
        val isOwn = statement.thread == thread?.number
        if (isOwn && asksOfOwnStatement) {
            asksOfOwnStatement = false
            return false
        }
        val isStepOver = if (isOwn) isStepDone(statement.depth) else isStepGivenUp()
        reason = when {
            isStepOver -> StopReason.StepDone
            isBreakpoint(statement) -> StopReason.Breakpoint(statement.sourceLine, statement.sourceFile, robot)
            else -> null
        }
        return reason != null
    }

    private fun isStepDone(depth: Int): Boolean = when (step) {
        StepKind.INTO -> true
        StepKind.OVER -> depth <= this.depth
        StepKind.OUT -> depth < this.depth
        null -> false
    }

    /** Whether the step's thread can no longer reach the step's end or, for a step into the next statement, not now. */
    private fun isStepGivenUp(): Boolean {
        if (step == null) return false
        val activity = thread?.let { run.activityOf(it.number) }
        return activity == null || (step == StepKind.INTO && !isChosen && activity != ThreadActivity.RUNNABLE)
    }

    /** A program of one file does not name its file. */
    private fun isBreakpoint(statement: DebugStatement): Boolean = breakpoints.any {
        val isOfFile = it.sourceFile == null || statement.sourceFile == null || it.sourceFile == statement.sourceFile
        it.line == statement.sourceLine && isOfFile
    }
}
