package robotran.runcontrol

import robotran.simulation.state.SessionState

/** States of a run at even distances, so that any moment can be looked at before it has been computed again. */
internal class StateTrack {
    private val kept = mutableListOf<SessionState>()

    /** Milliseconds between two states that are kept. */
    private var step = RunRecord.LOOK_MILLISECONDS

    fun look(state: SessionState) {
        if (state.milliseconds % step != 0L) return
        kept += state
        if (kept.size <= CAPACITY) return
        step *= 2
        kept.removeAll { it.milliseconds % step != 0L }
    }

    /** The last state that was kept up to [time]; null if there is none. */
    fun at(time: Long): SessionState? = kept.getOrNull(minOf(time / step, kept.lastIndex.toLong()).toInt())

    fun cutAt(time: Long) {
        while (kept.isNotEmpty() && kept.last().milliseconds > time) kept.removeLast()
    }

    companion object {
        /** How many states are kept at most, of about a kilobyte for each robot. */
        const val CAPACITY = 2_048
    }
}
