package robotran.runcontrol

/** Paused sessions of a run at other times, which save recomputing the run from the start. */
internal class SessionCheckpoints {
    private val takes = mutableListOf<SessionCursor>()
    val all: List<SessionCursor> get() = takes

    /** The one that has advanced furthest; null if there is none. */
    val furthest: SessionCursor? get() = takes.lastOrNull()

    /**
     * Removes and returns the session closest to [target] that leads to it and is past [after] milliseconds; null if
     * there is none.
     */
    fun take(target: Long, after: Long): SessionCursor? =
        takes.lastOrNull { it.canReach(target) && it.milliseconds > after }?.also(takes::remove)

    /**
     * Stores [take]. If there are too many sessions, closes the one with the closest neighbour, but never the furthest
     * one.
     */
    fun park(take: SessionCursor) {
        takes += take
        takes.sortBy { it.milliseconds }
        if (takes.size <= MAX) return
        val spare = takes.indices.toList().dropLast(1).minBy {
            takes[it].milliseconds -
                (takes.getOrNull(it - 1)?.milliseconds ?: 0)
        }
        takes.removeAt(spare).close()
    }

    /** Closes all sessions after [take], because the run continues differently from there. */
    fun closeAfter(take: SessionCursor) {
        val late = takes.filter {
            it.milliseconds > take.milliseconds || it.applied > take.applied ||
                it.session.isPaused
        }
        late.forEach(SessionCursor::close)
        takes.removeAll(late)
    }

    fun closeAll() {
        close()
        takes.clear()
    }

    fun close() = takes.forEach(SessionCursor::close)

    private companion object {
        /** Each session may hold a ROM log of 40 MB. */
        const val MAX = 3
    }
}
