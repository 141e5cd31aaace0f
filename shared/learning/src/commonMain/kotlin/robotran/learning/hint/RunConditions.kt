package robotran.learning.hint

import robotran.simulation.state.GoalProgress
import robotran.world.Goal
import robotran.world.GoalCondition
import robotran.world.HasParts
import robotran.world.TouchKind

/** What the run alone tells. */
internal val runConditions: List<HintCondition> = listOf(
    HintCondition("never moved") { attempt ->
        HintMatch().takeIf { attempt.driven < LITTLE && attempt.solutionLines.any { it.tokens.any(DRIVING::contains) } }
    },
    HintCondition("touched something") { attempt ->
        val mine = attempt.unmetConditions.filterIsInstance<GoalCondition.NeverTouch>().filter { it.who == null }
        HintMatch().takeIf { mine.any { goal -> attempt.run.robot.touched.any(goal.what::contains) } }
    },
    HintCondition("hit a wall") { attempt ->
        HintMatch().takeIf { TouchKind.WALLS in attempt.run.robot.touched || TouchKind.BARRIERS in attempt.run.robot.touched }
    },
    HintCondition("left the paper") { attempt ->
        val pose = attempt.run.robot.pose
        val paper = attempt.world.paper
        HintMatch().takeIf { pose.x !in 0.0..paper.width || pose.y !in 0.0..paper.height }
    },
    HintCondition("left its place") { it.unmetHint<GoalCondition.StayIn>() },
    HintCondition("went where it must not") { it.unmetHint<GoalCondition.StayOut>() },
    HintCondition("left the line") { it.unmetHint<GoalCondition.FollowLine>() },
    HintCondition("wrong text") { it.unmetHint<GoalCondition.ShowOnDisplay>() },
    HintCondition("no sound") { it.unmetHint<GoalCondition.PlaySound>() },
    HintCondition("never stops") { if (it.isRunning) HintMatch() else null },
    HintCondition("too slow") { attempt ->
        HintMatch().takeIf {
            attempt.unmetConditions.any { it is GoalCondition.EndWithin || (it as? GoalCondition.Reach)?.within != null }
        }
    },
    HintCondition("ended too early") { if (it.seconds < EARLY && !it.isRunning) HintMatch() else null },
)

private inline fun <reified T : GoalCondition> Attempt.unmetHint(): HintMatch? =
    if (unmetConditions.any { it is T }) HintMatch() else null

/** The conditions of all goals that are not met, also of those inside others. */
internal val Attempt.unmetConditions: List<GoalCondition> get() = unmetIn(world.goals, run.goals)

private fun Attempt.unmetIn(goals: List<Goal>, progress: List<GoalProgress>): List<GoalCondition> =
    goals.zip(progress).filter { (_, reached) -> unmet(listOf(reached)).isNotEmpty() }.flatMap { (goal, reached) ->
        val condition = goal.condition
        if (condition is HasParts) unmetIn(condition.goals, reached.parts) else listOf(condition)
    }

private val DRIVING = setOf("forward", "backward", "turn", "start", "motor", "drive")

/** A program that is over sooner, in seconds, has hardly begun. */
private const val EARLY = 1.0
