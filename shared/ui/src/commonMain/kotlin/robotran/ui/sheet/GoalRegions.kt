package robotran.ui.sheet

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.geometry.Shape

/**
 * A region of the paper that a goal is about.
 *
 * @property number which one it is of several to be reached one after the other, from 1; null if there is no order.
 * @property where the goal's place among the world's goals, then among the parts of that one, and so on.
 */
internal class GoalRegion(
    val kind: RegionKind,
    val shape: Shape,
    val number: Int?,
    val where: List<Int>,
) {
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

internal enum class RegionKind { REACH, STAY_OUT, STAY_IN }

/** The regions of [goals] and of their parts, each once. */
internal fun goalRegions(goals: List<Goal>): List<GoalRegion> =
    goals.flatMapIndexed { number, goal -> regions(goal, listOf(number), null) }.distinctBy { it.kind to it.shape }

private fun regions(goal: Goal, where: List<Int>, number: Int?): List<GoalRegion> = when (goal) {
    is Goal.Reach -> listOf(GoalRegion(RegionKind.REACH, goal.region, number, where))

    is Goal.StayOut -> listOf(GoalRegion(RegionKind.STAY_OUT, goal.region, null, where))

    is Goal.StayIn -> listOf(GoalRegion(RegionKind.STAY_IN, goal.region, null, where))

    is Goal.InOrder -> inOrder(goal.goals, where)

    is Goal.All -> goal.goals.flatMapIndexed { part, inner -> regions(inner, where + part, null) }

    is Goal.AnyOf -> goal.goals.flatMapIndexed { part, inner -> regions(inner, where + part, null) }

    is Goal.NeverTouch, is Goal.DrawTemplate, is Goal.InkLength, is Goal.FollowLine, is Goal.EndWithin, is Goal.ShowOnDisplay,
    is Goal.PlaySound,
    -> emptyList()
}

private fun inOrder(goals: List<Goal>, where: List<Int>): List<GoalRegion> {
    val several = goals.count { it is Goal.Reach } > 1
    var reached = 0
    return goals.flatMapIndexed { part, inner ->
        if (inner is Goal.Reach) reached++
        regions(inner, where + part, reached.takeIf { several && inner is Goal.Reach })
    }
}
