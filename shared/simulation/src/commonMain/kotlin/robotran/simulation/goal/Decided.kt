package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.Goal

/** Whether nothing that may still happen in the run changes how [goal] stands, which is [progress]. */
internal fun isDecided(goal: Goal, progress: GoalProgress): Boolean = when (goal) {
    is Goal.AnyOf -> partsOf(goal.goals, progress).run {
        any { isMetForGood(it.first, it.second) } || all { isDecided(it.first, it.second) }
    }

    else -> progress.status == GoalStatus.FAILED || isMetForGood(goal, progress)
}

private fun isMetForGood(goal: Goal, progress: GoalProgress): Boolean = progress.status == GoalStatus.MET && when (goal) {
    is Goal.Reach -> !goal.stays
    is Goal.InOrder -> partsOf(goal.goals, progress).all { isMetForGood(it.first, it.second) }
    is Goal.All -> partsOf(goal.goals, progress).all { isMetForGood(it.first, it.second) }
    is Goal.AnyOf -> partsOf(goal.goals, progress).any { isMetForGood(it.first, it.second) }
    else -> true
}

private fun partsOf(goals: List<Goal>, progress: GoalProgress): List<Pair<Goal, GoalProgress>> = goals.zip(progress.parts)
