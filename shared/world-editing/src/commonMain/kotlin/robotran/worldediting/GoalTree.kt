package robotran.worldediting

import robotran.world.Goal
import robotran.world.UnknownFields
import robotran.world.geometry.Shape

/** A goal and how deep it lies in others, 0 for those that lie in none. */
data class GoalEntry(val goal: Goal, val depth: Int)

/** All goals, each before those that lie in it, as a list shows them; a goal's number is its place here. */
fun allGoals(goals: List<Goal>): List<GoalEntry> = goals.flatMap { entries(it, depth = 0) }

private fun entries(goal: Goal, depth: Int): List<GoalEntry> =
    listOf(GoalEntry(goal, depth)) + goal.parts.flatMap { entries(it, depth + 1) }

/** The goals that lie in this one; none if it is no group. */
val Goal.parts: List<Goal>
    get() = when (this) {
        is Goal.InOrder -> goals
        is Goal.All -> goals
        is Goal.AnyOf -> goals
        else -> emptyList()
    }

/** Whether it is made of other goals. */
val Goal.isGroup: Boolean get() = this is Goal.InOrder || this is Goal.All || this is Goal.AnyOf

internal fun Goal.withParts(parts: List<Goal>): Goal = when (this) {
    is Goal.InOrder -> copy(goals = parts)
    is Goal.All -> copy(goals = parts)
    is Goal.AnyOf -> copy(goals = parts)
    else -> this
}

/** Where on the paper it is about; null if nowhere. */
val Goal.region: Shape?
    get() = when (this) {
        is Goal.Reach -> region
        is Goal.StayOut -> region
        is Goal.StayIn -> region
        else -> null
    }

internal fun Goal.withRegion(region: Shape): Goal = when (this) {
    is Goal.Reach -> copy(region = region, unknown = unknown.fittingRegion(this.region, region))
    is Goal.StayOut -> copy(region = region, unknown = unknown.fittingRegion(this.region, region))
    is Goal.StayIn -> copy(region = region, unknown = unknown.fittingRegion(this.region, region))
    else -> this
}

private fun UnknownFields.fittingRegion(before: Shape, after: Shape): UnknownFields =
    if (members.isEmpty() || before::class == after::class) this else UnknownFields(members - "region")

/** Whom it is about by name; null for the first robot, or if it is about nobody. */
val Goal.who: String?
    get() = when (this) {
        is Goal.Reach -> who
        is Goal.StayOut -> who
        is Goal.StayIn -> who
        is Goal.NeverTouch -> who
        is Goal.FollowLine -> who
        is Goal.EndWithin -> who
        is Goal.ShowOnDisplay -> who
        is Goal.PlaySound -> who
        is Goal.DrawTemplate, is Goal.InkLength, is Goal.InOrder, is Goal.All, is Goal.AnyOf -> null
    }

/** The same goal for [who], where it is about somebody. */
fun Goal.withWho(who: String?): Goal = when (this) {
    is Goal.Reach -> copy(who = who)
    is Goal.StayOut -> copy(who = who)
    is Goal.StayIn -> copy(who = who)
    is Goal.NeverTouch -> copy(who = who)
    is Goal.FollowLine -> copy(who = who)
    is Goal.EndWithin -> copy(who = who)
    is Goal.ShowOnDisplay -> copy(who = who)
    is Goal.PlaySound -> copy(who = who)
    is Goal.DrawTemplate, is Goal.InkLength, is Goal.InOrder, is Goal.All, is Goal.AnyOf -> this
}

/** The same goal in the author's own words, null for those that are made from its figures. */
fun Goal.saying(says: String?): Goal = when (this) {
    is Goal.Reach -> copy(says = says)
    is Goal.StayOut -> copy(says = says)
    is Goal.StayIn -> copy(says = says)
    is Goal.NeverTouch -> copy(says = says)
    is Goal.DrawTemplate -> copy(says = says)
    is Goal.InkLength -> copy(says = says)
    is Goal.FollowLine -> copy(says = says)
    is Goal.EndWithin -> copy(says = says)
    is Goal.ShowOnDisplay -> copy(says = says)
    is Goal.PlaySound -> copy(says = says)
    is Goal.InOrder -> copy(says = says)
    is Goal.All -> copy(says = says)
    is Goal.AnyOf -> copy(says = says)
}

/**
 * These goals with each put through [change], by its number, whole before its parts; what becomes null is gone, and so is a group that
 * nothing
 * is left of.
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
