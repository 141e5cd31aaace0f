package robotran.workshop.state

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus

/** The number of goals in a world that are [met] and that have [failed] for good; the rest of [all] is undecided. */
data class GoalCount(val all: Int = 0, val met: Int = 0, val failed: Int = 0) {
    val allMet: Boolean get() = met == all

    companion object {
        fun of(goals: List<GoalProgress>) = GoalCount(
            goals.size,
            goals.count { it.status == GoalStatus.MET },
            goals.count { it.status == GoalStatus.FAILED },
        )
    }
}
