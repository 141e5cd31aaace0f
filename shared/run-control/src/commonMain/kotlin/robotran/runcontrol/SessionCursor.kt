package robotran.runcontrol

import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.Session
import robotran.simulation.StopReason

/** A session on its way through a run: it starts at 0 and applies the run's inputs at their times. */
internal class SessionCursor(setup: RunSetup, watched: Int) {
    val session: Session = setup.begin().also { it.watched = watched }
    private var isFinished = false

    /** Number of the run's inputs applied so far. */
    var applied = 0

    val milliseconds: Long get() = session.milliseconds

    /** Whether the session is at [time] or can advance to it. */
    fun canReach(time: Long): Boolean = milliseconds < time || (milliseconds == time && !session.isPaused)

    /** Applies those of [inputs] that are due now, and ends the run at [finish]. */
    fun applyDueInputs(inputs: List<RecordedInput>, finish: Long?) {
        while (applied < inputs.size && inputs[applied].milliseconds <= milliseconds) {
            session.apply(inputs[applied++].input)
        }
        if (finish != null && finish <= milliseconds && !isFinished) {
            session.finish()
            isFinished = true
        }
    }

    /**
     * Advances by [milliseconds], or less if the program reaches one of [breakpoints] earlier, or that of another robot
     * one of [others]; null if none does.
     */
    fun run(
        milliseconds: Int,
        breakpoints: Set<Breakpoint> = emptySet(),
        others: Map<Int, Set<Breakpoint>> = emptyMap(),
    ): StopReason? {
        if (breakpoints.isEmpty() && others.isEmpty()) {
            session.advance(milliseconds)
            return null
        }
        session.breakpoints = breakpoints
        session.otherBreakpoints = others
        val end = this.milliseconds + milliseconds
        while (this.milliseconds < end) {
            // A program that starts meanwhile must not pass a breakpoint.
            val part = if (session.areBreakpointsReady) (end - this.milliseconds).toInt() else 1
            val reason = session.runUntilStop(part)
            if (reason is StopReason.Breakpoint) return reason
        }
        return null
    }

    /** Starts or continues a step, for at most [milliseconds]; null if it takes longer. */
    fun step(
        step: PlaybackState.Stepping,
        isBegun: Boolean,
        milliseconds: Int,
        breakpoints: Set<Breakpoint>,
        others: Map<Int, Set<Breakpoint>>,
    ): StopReason? {
        session.breakpoints = breakpoints
        session.otherBreakpoints = others
        val reason =
            if (isBegun) {
                session.continueStep(milliseconds)
            } else {
                session.stepStatement(step.kind, milliseconds, step.thread)
            }
        return reason.takeIf { it != StopReason.TimeUp }
    }

    fun close() = session.close()
}
