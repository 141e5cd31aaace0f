package robotran.runcontrol

import robotran.simulation.state.SessionState

/** Records states of a run at equal intervals, to show any moment before it has been recomputed. */
internal class StateTrack {
    private val kept = mutableListOf<SessionState>()

    /** Milliseconds between two recorded states. */
    private var step = RunRecord.LOOK_MILLISECONDS

    /** All of them, from the first on, at most [CAPACITY]. */
    val all: List<SessionState> get() = kept.toList()

    fun record(state: SessionState) {
        if (state.milliseconds % step != 0L) return
        kept += state
        if (kept.size <= CAPACITY) return
        step *= 2
        kept.removeAll { it.milliseconds % step != 0L }
    }

    /** The last recorded state up to [time]; null if there is none. */
    fun at(time: Long): SessionState? = kept.getOrNull(minOf(time / step, kept.lastIndex.toLong()).toInt())

    fun cutAt(time: Long) {
        while (kept.isNotEmpty() && kept.last().milliseconds > time) kept.removeLast()
    }

    companion object {
        /** Max number of recorded states, each about a kilobyte per robot. */
        const val CAPACITY = 2_048
    }
}
