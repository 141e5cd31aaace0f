package robotran.worldediting

import robotran.world.Goal
import robotran.world.HasRegion
import robotran.world.UnknownFields
import robotran.world.geometry.Shape

/** A goal and its nesting depth, 0 at the top level. */
data class GoalEntry(val goal: Goal, val depth: Int)

/** All goals, each before its parts, as in a list; the position in this list is the goal's index. */
fun allGoals(goals: List<Goal>): List<GoalEntry> = goals.flatMap { entries(it, depth = 0) }

private fun entries(goal: Goal, depth: Int): List<GoalEntry> =
    listOf(GoalEntry(goal, depth)) + goal.parts.flatMap { entries(it, depth + 1) }

/** The same goal with another region, if it has one. */
internal fun Goal.withRegion(region: Shape): Goal = when (val condition = condition) {
    is HasRegion -> copy(
        condition = condition.withRegion(region),
        unknown = unknown.fittingRegion(condition.region, region),
    )

    else -> this
}

private fun UnknownFields.fittingRegion(before: Shape, after: Shape): UnknownFields =
    if (members.isEmpty() || before::class == after::class) this else UnknownFields(members - "region")

/**
 * Maps each goal by [change], with its index, before its parts. A null result removes the goal; a group that becomes
 * empty is removed too.
 */
internal fun List<Goal>.changed(change: (Int, Goal) -> Goal?): List<Goal> = GoalChange(change).of(this)

private class GoalChange(private val change: (Int, Goal) -> Goal?) {
    private var number = 0

    fun of(goals: List<Goal>): List<Goal> = goals.mapNotNull { goal ->
        val changed = change(number++, goal)
        if (changed == null) {
            number += allGoals(goal.parts).size
            null
        } else {
            val parts = of(goal.parts)
            if (goal.isGroup && parts.isEmpty()) null else changed.withParts(parts)
        }
    }
}
