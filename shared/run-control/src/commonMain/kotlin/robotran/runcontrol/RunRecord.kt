package robotran.runcontrol

import robotran.simulation.state.SessionState
import robotran.world.World

/** What is known of a run up to where it has come, in bounded memory: the longer it is, the more coarsely. */
internal class RunRecord(world: World) {
    private val states = StateTrack()
    private val marks = MarkTrack()
    private val ending = RunEndDetector(world)
    val chart = ChartTrack(world.robots.size)
    val calls = RomCallTrack(world.robots.size)
    val timeline: List<TimelineMark> get() = marks.marks

    /** How far it goes, in milliseconds. */
    var end = -1L
        private set

    /** When the run was over and its goals were decided; null as long as it is not. */
    var finished: Long? = null
        private set

    /** Sees the run as it is at [time]; what lies in the past is known already. */
    fun look(time: Long, state: () -> SessionState) {
        if (time <= end) return
        end = time
        if (time % LOOK_MILLISECONDS != 0L) return
        val now = state()
        states.look(now)
        chart.look(now)
        calls.look(now)
        marks.look(now)
        if (finished == null && ending.isOver(now)) finished = time
    }

    /** What has become of the goals, which were decided just now. */
    fun lookAgain(state: SessionState) = marks.look(state)

    /** The run at [time], or shortly before; null if that is not known. */
    fun at(time: Long): SessionState? = states.at(time)

    /** From [state] on the run goes on differently. */
    fun cutAt(state: SessionState) {
        val time = state.milliseconds
        end = time
        finished = finished?.takeIf { it <= time }
        states.cutAt(time)
        chart.cutAt(time)
        calls.cutAt(state)
        marks.cutAt(state)
        ending.cutAt()
    }

    companion object {
        /** How often a run is looked at. */
        const val LOOK_MILLISECONDS = 10L
    }
}
