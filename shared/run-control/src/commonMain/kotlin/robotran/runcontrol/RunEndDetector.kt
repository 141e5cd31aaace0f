package robotran.runcontrol

import robotran.brick.state.RunState
import robotran.simulation.grade.isTaskCompleted
import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.World

/** Detects the end of a run in [world], so that its goals can be decided like in grading. */
internal class RunEndDetector(private val world: World) {
    private var before: SessionState? = null
    private var quiet = 0L
    private var goals: List<GoalProgress>? = null
    private var isCompleted = false
    private var isMetAtStart = false

    /**
     * Whether the task is completed, or the first robot's program has ended and nothing has moved or sounded for
     * [QUIET_MILLISECONDS], or the time limit is reached. Always false in a world without goals.
     */
    fun isOver(state: SessionState): Boolean {
        if (world.goals.isEmpty()) return false
        if (isCompleted(state)) return true
        val last = before
        before = state
        val isQuiet = hasEnded(state) && state.robots.none { it.brick.sounding }
        quiet =
            if (last != null && isQuiet && !moves(last, state)) quiet + state.milliseconds - last.milliseconds else 0
        return quiet >= QUIET_MILLISECONDS || isTimeUp(state)
    }

    /** Whether the time limit is reached. */
    fun isTimeUp(state: SessionState): Boolean = state.milliseconds >= world.timeLimit * MILLISECONDS_PER_SECOND

    /**
     * Whether the task is completed, although the program may still run. A task whose goals are met from the start on
     * has nothing to complete, so such a run goes on until its program has ended.
     */
    fun isCompleted(state: SessionState): Boolean {
        // The goals rarely change.
        if (state.goals !== goals) {
            goals = state.goals
            isCompleted = isTaskCompleted(world, state.goals)
            if (isCompleted && state.milliseconds <= FIRST_LOOK_MILLISECONDS) isMetAtStart = true
        }
        return isCompleted && !isMetAtStart
    }

    fun cutAt() {
        before = null
        quiet = 0
    }

    private fun hasEnded(state: SessionState) = state.brick.run is RunState.Ended || state.brick.run is RunState.Failed

    private fun moves(last: SessionState, now: SessionState) =
        last.blocks != now.blocks || last.robots.indices.any { last.robots[it].robot.pose != now.robots[it].robot.pose }

    private companion object {
        /** Same as in grading. */
        const val QUIET_MILLISECONDS = 300L

        /** When goals are evaluated for the first time; no robot has left its place by then. */
        const val FIRST_LOOK_MILLISECONDS = 10L
        const val MILLISECONDS_PER_SECOND = 1_000L
    }
}
