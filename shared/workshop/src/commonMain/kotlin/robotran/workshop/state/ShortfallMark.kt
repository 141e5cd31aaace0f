package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalShortfall

/**
 * What was missing for a goal, as the goals and the sheet show it.
 *
 * @property where the index of the goal among the world's goals, then among its parts, and so on.
 * @property number the number of its mark on the sheet, from 1; null if it has no place.
 */
@Immutable
data class ShortfallMark(val where: List<Int>, val goal: GoalProgress, val shortfall: GoalShortfall, val number: Int?) {
    /** What its mark says: a letter, since goals that have an order have numbers on the sheet. */
    val sign: String? get() = number?.let { LETTERS.getOrNull(it - 1)?.toString() ?: "$it" }

    private companion object {
        const val LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
    }
}

/** What was missing for [goals] and for the parts of those that are groups, in their order. */
fun shortfallMarks(goals: List<GoalProgress>): List<ShortfallMark> {
    var number = 0
    return goals.flatMapIndexed { index, goal -> leaves(goal, listOf(index)) }.map { (where, goal, shortfall) ->
        ShortfallMark(where, goal, shortfall, if (shortfall.place == null) null else ++number)
    }
}

private fun leaves(goal: GoalProgress, where: List<Int>): List<Triple<List<Int>, GoalProgress, GoalShortfall>> {
    val shortfall = goal.shortfall ?: return emptyList()
    if (goal.parts.isEmpty()) return listOf(Triple(where, goal, shortfall))
    if (shortfall is GoalShortfall.PartNotMet && shortfall.isChoice) {
        // One of them is enough, so only the one that was closest is told.
        return leaves(goal.parts[shortfall.part], where + shortfall.part)
    }
    return goal.parts.flatMapIndexed { index, part -> leaves(part, where + index) }
}
