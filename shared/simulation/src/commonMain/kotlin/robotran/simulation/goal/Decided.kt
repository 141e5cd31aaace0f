package robotran.simulation.goal

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.HasParts

/** Whether no further event of the run can change the status of [goal], which is at [progress]. */
internal fun isDecided(goal: Goal, progress: GoalProgress): Boolean {
    val condition = goal.condition
    if (condition is HasParts && !condition.needsAll) {
        return partsOf(condition, progress).run {
            any { isMetForGood(it.first, it.second) } ||
                all { isDecided(it.first, it.second) }
        }
    }
    return progress.status == GoalStatus.FAILED || isMetForGood(goal, progress)
}

internal fun isMetForGood(goal: Goal, progress: GoalProgress): Boolean {
    val condition = goal.condition
    return when {
        progress.status != GoalStatus.MET -> false
        condition !is HasParts -> condition.staysMet
        condition.needsAll -> partsOf(condition, progress).all { isMetForGood(it.first, it.second) }
        else -> partsOf(condition, progress).any { isMetForGood(it.first, it.second) }
    }
}

private fun partsOf(condition: HasParts, progress: GoalProgress): List<Pair<Goal, GoalProgress>> =
    condition.goals.zip(progress.parts)
