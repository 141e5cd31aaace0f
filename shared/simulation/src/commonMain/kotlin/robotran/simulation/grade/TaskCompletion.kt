package robotran.simulation.grade

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.GoalStatus
import robotran.world.Goal
import robotran.world.World

/**
 * Whether the task of [world] is completed: all its goals are met, which no further event can change, and none is a
 * minimum after which a pupil may want to go on ([robotran.world.GoalCondition.isMinimum]). False without goals.
 *
 * @param goals the progress of the world's goals, in its order.
 */
fun isTaskCompleted(world: World, goals: List<GoalProgress>): Boolean = goals.isNotEmpty() &&
    goals.size == world.goals.size &&
    goals.all { it.status == GoalStatus.MET } &&
    world.goals.none(::hasMinimum)

private fun hasMinimum(goal: Goal): Boolean = goal.condition.isMinimum || goal.parts.any(::hasMinimum)
