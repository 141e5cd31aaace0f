package robotran.learning.hint

import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.GoalStatus
import robotran.world.Goal

/** What a run lacked for [goal], which has no parts. */
internal class MissedGoal(val goal: Goal, val shortfall: GoalShortfall)

/** The goals that the run has not met, each in its innermost part. */
internal val Attempt.missedGoals: List<MissedGoal>
    get() = world.goals.zip(run.goals).mapNotNull { (goal, progress) ->
        progress.shortfall?.takeIf { progress.status != GoalStatus.MET }?.let { innermost(goal, it) }
    }

private fun innermost(goal: Goal, shortfall: GoalShortfall): MissedGoal = if (shortfall is GoalShortfall.PartNotMet) {
    innermost(
        goal.parts[shortfall.part],
        shortfall.shortfall,
    )
} else {
    MissedGoal(goal, shortfall)
}

/** Whether the run lacked something of this kind. */
internal inline fun <reified T : GoalShortfall> Attempt.lacked(): Boolean = missedGoals.any { it.shortfall is T }
