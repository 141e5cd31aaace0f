package robotran.runcontrol

import robotran.brick.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState

/** Detects the events of a run from its successive states, and stores them, thinned out where there are many. */
internal class MarkTrack {
    private val kept = mutableListOf<TimelineMark>()
    private var before: SessionState? = null

    /** Min distance of frequent marks of one kind and robot, in milliseconds; closer ones count as one. */
    private var gap = 0L
    private var given: List<TimelineMark>? = null

    /** In order of time; the same list until one is added. */
    val marks: List<TimelineMark> get() = given ?: kept.toList().also { given = it }

    fun record(state: SessionState) {
        val last = before
        before = state
        if (last == null) return
        state.robots.forEachIndexed { robot, now -> recordRobot(state.milliseconds, robot, last.robots[robot], now) }
        if (state.goals !== last.goals) recordGoals(last, state)
    }

    /** Discards everything after [state], because the run continues differently from there. */
    fun cutAt(state: SessionState) {
        kept.removeAll { it.milliseconds > state.milliseconds }
        given = null
        before = state
    }

    private fun recordRobot(time: Long, robot: Int, last: RobotSnapshot, now: RobotSnapshot) {
        val wasRunning = last.brick.run is RunState.Running
        val run = now.brick.run
        if (!wasRunning && run is RunState.Running) add(TimelineMark(time, MarkKind.START, robot))
        if (wasRunning && run is RunState.Ended) add(TimelineMark(time, MarkKind.END, robot))
        if (run is RunState.Failed && last.brick.run != run) {
            add(TimelineMark(time, MarkKind.FAILURE, robot, run.failure.message))
        }
        if (now.bumps > last.bumps) add(TimelineMark(time, MarkKind.BUMP, robot))
        if (now.brick.sounding && !last.brick.sounding) add(TimelineMark(time, MarkKind.BEEP, robot))
        if (now.brick.isSending && !last.brick.isSending) add(TimelineMark(time, MarkKind.MESSAGE, robot))
        if (now.warnings.size > last.warnings.size) {
            val newest = now.warnings.lastOrNull { it !in last.warnings } ?: now.warnings.last()
            add(TimelineMark(time, MarkKind.WARNING, robot, newest.message))
        }
    }

    private fun recordGoals(last: SessionState, state: SessionState) {
        state.goals.zip(last.goals) { now, then ->
            if (now.status != then.status) {
                when (now.status) {
                    GoalStatus.MET -> add(TimelineMark(state.milliseconds, MarkKind.GOAL, text = now.sentence))
                    GoalStatus.FAILED -> add(TimelineMark(state.milliseconds, MarkKind.GOAL_LOST, text = now.sentence))
                    GoalStatus.PENDING -> Unit
                }
            }
        }
    }

    private fun add(mark: TimelineMark) {
        if (gap > 0 && !mark.kind.isRare && isNearAnother(mark)) return
        kept += mark
        given = null
        while (kept.size > CAPACITY) thinOut()
    }

    private fun isNearAnother(mark: TimelineMark): Boolean {
        val last = kept.lastOrNull { it.kind == mark.kind && it.robot == mark.robot } ?: return false
        return mark.milliseconds - last.milliseconds < gap
    }

    private fun thinOut() {
        gap = if (gap == 0L) FIRST_GAP else gap * 2
        val last = mutableMapOf<Pair<MarkKind, Int>, Long>()
        val frequent = kept.count { !it.kind.isRare }
        // Rare marks are removed only if there are no others, such as when a program fails repeatedly.
        if (frequent == 0) repeat(kept.size / 2) { kept.removeAt(it) }
        kept.removeAll { mark ->
            val from = last[mark.kind to mark.robot]
            val isTooNear = !mark.kind.isRare && from != null && mark.milliseconds - from < gap
            if (!isTooNear) last[mark.kind to mark.robot] = mark.milliseconds
            isTooNear
        }
    }

    companion object {
        /** Max number of marks: more than the clickable positions of a timeline. */
        const val CAPACITY = 1_000

        /** In milliseconds. */
        private const val FIRST_GAP = 100L
    }
}
