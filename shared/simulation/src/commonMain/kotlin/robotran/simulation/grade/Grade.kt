package robotran.simulation.grade

import robotran.simulation.RunReport
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/**
 * The result of one run for the goals of its world.
 *
 * @property seed the seed of the run's random numbers.
 * @property passed whether all goals are met; false in a world without goals.
 * @property goals their final progress, in the world's order.
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
    val unmet: List<GoalProgress> get() = goals.filter { it.status != GoalStatus.MET }
}
