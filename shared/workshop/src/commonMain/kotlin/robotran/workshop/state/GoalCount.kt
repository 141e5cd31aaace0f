package robotran.workshop.state

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/** How many goals of a world are [met] and how many cannot be met any more; the others of [all] are not decided yet. */
data class GoalCount(val all: Int = 0, val met: Int = 0, val failed: Int = 0) {
    val allMet: Boolean get() = met == all

    companion object {
        fun of(goals: List<GoalProgress>) = GoalCount(
            goals.size,
            goals.count { it.status == GoalStatus.MET },
            goals.count {
                it.status ==
                    GoalStatus.FAILED
            },
        )
    }
}
