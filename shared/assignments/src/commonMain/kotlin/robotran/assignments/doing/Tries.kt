package robotran.assignments.doing

import robotran.projects.AssignmentTries
import robotran.projects.BestTry
import robotran.projects.ProjectProgram
import robotran.projects.TryResult
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import kotlin.math.roundToInt

/** Whether this try did better than [other]: it met more goals, or as many in less time. */
fun TryResult.isBetterThan(other: TryResult): Boolean =
    goalsMet > other.goalsMet || (goalsMet == other.goalsMet && milliseconds < other.milliseconds)

/**
 * These tries and [ended], which counts as one more if it [isNew], and not if an earlier one has gone on.
 *
 * The best has the most goals met. Of those with as many, one with changed programs is better than one with [start],
 * what the pupil began with. Else the quickest is best if all goals are met; if not, the one that came nearest to them,
 * and of equals the latest.
 */
fun AssignmentTries.with(ended: BestTry, isNew: Boolean, start: List<ProjectProgram>): AssignmentTries {
    val best = best
    val isBest = best == null || ended.isBetterThan(best, start)
    return AssignmentTries(if (isNew) tries + 1 else tries, if (isBest) ended else best)
}

/** How much of all [goals] is reached, 0..100; null without goals. */
fun percentOf(goals: List<GoalProgress>): Int? {
    if (goals.isEmpty()) return null
    val hundredths = goals.sumOf { if (it.status == GoalStatus.MET) HUNDRED else (it.progress * HUNDRED).roundToInt() }
    return hundredths / goals.size
}

private fun BestTry.isBetterThan(other: BestTry, start: List<ProjectProgram>): Boolean {
    if (result.goalsMet != other.result.goalsMet) return result.goalsMet > other.result.goalsMet
    val isChanged = plain(programs) != plain(start)
    if (isChanged != (plain(other.programs) != plain(start))) return isChanged
    if (result.isSolved) return result.milliseconds < other.result.milliseconds
    val known = percent ?: return true
    return known >= (other.percent ?: return true)
}

private fun plain(programs: List<ProjectProgram>) = programs.map { it.copy(view = null) }

private const val HUNDRED = 100
