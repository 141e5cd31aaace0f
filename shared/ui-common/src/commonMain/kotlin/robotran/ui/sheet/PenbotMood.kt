package robotran.ui.sheet

import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState

/** How a penbot takes its run. */
enum class PenbotMood {
    CALM,

    /** It has just bumped into something. */
    SULKING,

    /** All goals of the world are met. */
    GLAD,
}

/**
 * The mood of the robot with the index [robot]. It follows from [state] alone, so it is the same whenever that moment
 * is shown again.
 */
fun penbotMood(state: SessionState, robot: Int): PenbotMood {
    if (state.goals.isNotEmpty() && state.goals.all { it.status == GoalStatus.MET }) return PenbotMood.GLAD
    val bumpedAt = state.robots[robot].bumpedAt ?: return PenbotMood.CALM
    return if (state.milliseconds - bumpedAt <= SULKS_FOR) PenbotMood.SULKING else PenbotMood.CALM
}

/** Milliseconds of virtual time: long enough to be seen, over before the next bump. */
private const val SULKS_FOR = 1_200L
