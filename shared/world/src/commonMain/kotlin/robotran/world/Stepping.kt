package robotran.world

import robotran.rom.DebuggableRun
import robotran.rom.StatementWatch
import robotran.rom.StepKind

/**
 * Stops [run] at breakpoints and, if a [step] is to be made, behind it. The statement that the run stands before when this is made
 * belongs to the step.
 */
internal class Stepping(
    private val run: DebuggableRun,
    private val breakpoints: Set<Int>,
    private val step: StepKind? = null,
) : StatementWatch {
    private val depth = run.callStack.size - 1
    private val begun = run.statementsBegun
    private val ownStatements = if (step != null && run.isBeforeStatement) 1 else 0

    /** Why the run was stopped, null as long as it was not. */
    var reason: StopReason? = null
        private set

    override fun pausesBefore(sourceLine: Int, depth: Int): Boolean {
        reason = when {
            run.statementsBegun - begun < ownStatements -> null
            isStepDone(depth) -> StopReason.StepDone
            sourceLine in breakpoints -> StopReason.Breakpoint(sourceLine)
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
}
