package robotran.runcontrol

import robotran.simulation.state.GoalProgress
import robotran.simulation.state.SessionState
import robotran.world.World

/** The known history of a run, in bounded memory: the resolution decreases with the length. */
internal class RunRecord(world: World) {
    private val states = StateTrack()
    private val marks = MarkTrack()
    private val ending = RunEndDetector(world)
    val chart = ChartTrack(world.robots.map { it.description })
    val calls = RomCallTrack(world.robots.size)

    /** States at equal intervals, the longer the run the further apart. */
    val history: List<SessionState> get() = states.all
    val timeline: List<TimelineMark> get() = marks.marks

    /** The end of the recorded run, in milliseconds. */
    var end = -1L
        private set

    /** When the run ended and its goals were decided; null before that. */
    var finished: Long? = null
        private set

    /** The hash of the session when the run ended; null before that. */
    var traceHash: String? = null

    /**
     * Whether the run ended because its task was completed or its time was up, although a program may still have run.
     */
    var isCutShort = false
        private set

    /** The goals at the end of the recorded run. */
    var goals: List<GoalProgress> = emptyList()
        private set

    /** Records the run at [time]; ignores times that are already recorded. */
    fun record(time: Long, state: () -> SessionState) {
        if (time <= end) return
        end = time
        if (time % LOOK_MILLISECONDS != 0L) return
        val now = state()
        states.record(now)
        chart.record(now)
        calls.record(now)
        marks.record(now)
        goals = now.goals
        if (finished == null && ending.isOver(now)) {
            finished = time
            isCutShort = ending.isCompleted(now) || ending.isTimeUp(now)
        }
    }

    /** Records the goals again after they were decided. */
    fun observeGoals(state: SessionState) {
        marks.record(state)
        goals = state.goals
    }

    /** The state at [time], or shortly before; null if it is not recorded. */
    fun at(time: Long): SessionState? = states.at(time)

    /** Discards everything after [state], because the run continues differently from there. */
    fun cutAt(state: SessionState) {
        val time = state.milliseconds
        end = time
        finished = finished?.takeIf { it <= time }
        if (finished == null) traceHash = null
        isCutShort = isCutShort && finished != null
        goals = state.goals
        states.cutAt(time)
        chart.cutAt(time)
        calls.cutAt(state)
        marks.cutAt(state)
        ending.cutAt()
    }

    companion object {
        /** Time between two observations of a run. */
        const val LOOK_MILLISECONDS = 10L
    }
}
