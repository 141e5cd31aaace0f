package robotran.assignments.doing

import robotran.projects.AssignmentTries
import robotran.projects.BestTry
import robotran.projects.TryResult

/** Whether this try did better than [other]: it met more goals, or as many in less time. */
fun TryResult.isBetterThan(other: TryResult): Boolean =
    goalsMet > other.goalsMet || (goalsMet == other.goalsMet && milliseconds < other.milliseconds)

/** These tries and [ended], which counts as one more if it [isNew], and not if an earlier one has gone on. */
fun AssignmentTries.with(ended: BestTry, isNew: Boolean): AssignmentTries {
    val best = best
    val isBest = best == null || ended.result.isBetterThan(best.result)
    return AssignmentTries(if (isNew) tries + 1 else tries, if (isBest) ended else best)
}
