package robotran.simulation.grade

import robotran.simulation.RunReport
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * What came of one run for the goals of its world.
 *
 * @property seed what the run left to chance was drawn from.
 * @property passed whether all goals are met; false in a world that has none.
 * @property goals how they stand at the end, in the world's order.
 * @property seconds virtual time of the run.
 * @property report the whole run.
 */
data class Grade(
    val seed: Int,
    val passed: Boolean,
    val goals: List<GoalProgress>,
    val seconds: Double,
    val report: RunReport,
) {
    /** The goals that are not met. */
    val unmet: List<GoalProgress> get() = goals.filter { it.status != GoalStatus.MET }
}
