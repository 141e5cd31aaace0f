package robotran.simulation.grade

import robotran.simulation.goal.isMetForGood
import robotran.simulation.state.GoalProgress
import robotran.world.Goal
import robotran.world.World

/**
 * Whether the task of [world] is completed: all its goals are met, no further event can change that, and none is a
 * minimum after which a pupil may want to go on ([robotran.world.GoalCondition.isMinimum]). False without goals.
 *
 * @param goals the progress of the world's goals, in its order.
 */
fun isTaskCompleted(world: World, goals: List<GoalProgress>): Boolean = goals.isNotEmpty() &&
    goals.size == world.goals.size &&
    goals.indices.all { isMetForGood(world.goals[it], goals[it]) } &&
    world.goals.none(::hasMinimum)

private fun hasMinimum(goal: Goal): Boolean = goal.condition.isMinimum || goal.parts.any(::hasMinimum)
