package robotran.workshop.run

import robotran.assignments.doing.percentOf
import robotran.brick.state.RunState
import robotran.projects.TryResult
import robotran.projects.repeatable
import robotran.simulation.state.GoalStatus
import robotran.workshop.state.EndedAttempt

/** Tells the runs that Run has started from replays and from programs that were sent to run at once. */
internal class AttemptRecorder(private val run: DebuggedRun) {
    private var number = 0
    private var isTry = false
    private var last: EndedAttempt? = null

    /** Run has started a new run. */
    fun begin() {
        isTry = true
        number++
    }

    /** The brick's own Run goes on with the present run, or starts it. */
    fun goOn() {
        if (!isTry) begin()
    }

    /** The present run is no try. */
    fun leave() {
        isTry = false
    }

    /** The present try, once it is over; the same object until something about that changes. */
    fun ended(): EndedAttempt? {
        if (!isTry) return null
        val outcome = run.player.outcome
        val before = last?.takeIf { it.number == number }
        val state = run.player.session.state
        val met = outcome.goals.count { it.status == GoalStatus.MET }
        val end = when {
            outcome.finished != null -> outcome.finished
            run.world.goals.isNotEmpty() -> null

            // Without goals, nothing decides when a run is over but its program.
            else -> before?.result?.milliseconds ?: state.milliseconds.takeIf { state.brick.run.isOver }
        } ?: return null
        if (before != null && before.result.milliseconds == end && before.result.goalsMet == met) return before
        val trace = outcome.traceHash ?: run.player.session.traceHash
        return EndedAttempt(
            number,
            run.loadedPrograms,
            run.firstSlots.first(),
            run.player.inputs.repeatable().takeWhile { it.milliseconds <= end },
            TryResult(met, run.world.goals.size, end, trace),
            percentOf(outcome.goals),
            state,
        ).also { last = it }
    }

    private val RunState.isOver: Boolean get() = this is RunState.Ended || this is RunState.Failed
}
