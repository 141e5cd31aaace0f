package robotran.runcontrol

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * What is known of the end of a run, also while an earlier time is shown.
 *
 * @property goals the goals at the end of the known run.
 * @property finished when the run was over and its goals were decided, in milliseconds; null before that.
 * @property traceHash of the session at that time; null before that.
 */
data class RunOutcome(
    val goals: List<GoalProgress> = emptyList(),
    val finished: Long? = null,
    val traceHash: String? = null,
) {
    /** Whether all goals are met, although the run may go on, as while a pupil draws more than is needed. */
    val allMet: Boolean get() = goals.isNotEmpty() && goals.all { it.status == GoalStatus.MET }

    /** Whether the run is over and has met all goals of its world. */
    val isSolved: Boolean get() = finished != null && allMet
}
