package robotran.runcontrol

import robotran.rcxrom.program.StepKind
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.Session
import robotran.simulation.StopReason

/** A session on its way through a run: it began at 0, and what was done to the run is done to it as its time comes. */
internal class SessionCursor(setup: RunSetup, watched: Int) {
    val session: Session = setup.begin().also { it.watched = watched }
    private var isFinished = false

    /** How many of the run's inputs have been done to it. */
    var applied = 0

    val milliseconds: Long get() = session.milliseconds

    /** Whether the session as it is now is the run at [time], or comes to it. */
    fun leadsTo(time: Long): Boolean = milliseconds < time || (milliseconds == time && !session.isPaused)

    /** Does what the run's [inputs] and its end at [finish] have for this time. */
    fun doWhatIsDue(inputs: List<RecordedInput>, finish: Long?) {
        while (applied < inputs.size &&
            inputs[applied].milliseconds <= milliseconds
        ) {
            session.apply(inputs[applied++].input)
        }
        if (finish != null && finish <= milliseconds && !isFinished) {
            session.finish()
            isFinished = true
        }
    }

    /** Lets [milliseconds] pass, or less if the program comes to one of [breakpoints] before; null if it does not. */
    fun run(milliseconds: Int, breakpoints: Set<Breakpoint>): StopReason? {
        if (breakpoints.isEmpty()) {
            session.advance(milliseconds)
            return null
        }
        session.breakpoints = breakpoints
        val end = this.milliseconds + milliseconds
        while (this.milliseconds < end) {
            // A program that is started meanwhile must not run past a breakpoint.
            val part = if (session.isDebuggable) (end - this.milliseconds).toInt() else 1
            val reason = session.runUntilStop(part)
            if (reason is StopReason.Breakpoint) return reason
        }
        return null
    }

    /** Goes on with a step, or begins it, for [milliseconds] at most; null if it takes longer. */
    fun step(kind: StepKind, isBegun: Boolean, milliseconds: Int, breakpoints: Set<Breakpoint>): StopReason? {
        session.breakpoints = breakpoints
        val reason = if (isBegun) session.continueStep(milliseconds) else session.stepStatement(kind, milliseconds)
        return reason.takeIf { it != StopReason.TimeUp }
    }

    fun close() = session.close()
}
