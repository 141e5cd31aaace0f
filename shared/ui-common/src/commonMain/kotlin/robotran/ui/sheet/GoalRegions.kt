package robotran.ui.sheet

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.HasParts
import robotran.world.HasRegion
import robotran.world.RegionRole
import robotran.world.geometry.Shape

/**
 * A region of the paper that belongs to a goal.
 *
 * @property number its index from 1 among regions to be reached in order; null without an order.
 * @property where the index of the goal among the world's goals, then among its parts, and so on.
 */
class GoalRegion(val role: RegionRole, val shape: Shape, val number: Int?, val where: List<Int>) {
    fun isMet(goals: List<GoalProgress>): Boolean {
        var parts = goals
        var goal: GoalProgress? = null
        for (number in where) {
            goal = parts.getOrNull(number) ?: return false
            parts = goal.parts
        }
        return goal?.status == GoalStatus.MET
    }
}

/** The regions of [goals] and of their parts, without duplicates. */
fun goalRegions(goals: List<Goal>): List<GoalRegion> =
    goals.flatMapIndexed { number, goal -> regions(goal, listOf(number), null) }.distinctBy { it.role to it.shape }

private fun regions(goal: Goal, where: List<Int>, number: Int?): List<GoalRegion> {
    val condition = goal.condition
    return when {
        condition is HasRegion -> listOf(GoalRegion(condition.role, condition.region, number, where))
        condition is HasParts && condition.isOrdered -> inOrder(condition.goals, where)
        else -> goal.parts.flatMapIndexed { part, inner -> regions(inner, where + part, null) }
    }
}

private fun inOrder(goals: List<Goal>, where: List<Int>): List<GoalRegion> {
    val several = goals.count { it.isTarget } > 1
    var reached = 0
    return goals.flatMapIndexed { part, inner ->
        if (inner.isTarget) reached++
        regions(inner, where + part, reached.takeIf { several && inner.isTarget })
    }
}

private val Goal.isTarget: Boolean get() = (condition as? HasRegion)?.role == RegionRole.TARGET
