package robotran.runcontrol

/** Sessions of a run that stand still at other times, so that the way there need not be gone again. */
internal class SessionCheckpoints {
    private val takes = mutableListOf<SessionCursor>()
    val all: List<SessionCursor> get() = takes

    /** The one that has come furthest; null if there is none. */
    val furthest: SessionCursor? get() = takes.lastOrNull()

    /**
     * Gives back the one nearest to [target] that leads to it and has come further than [after] milliseconds; null if
     * there is none.
     */
    fun take(target: Long, after: Long): SessionCursor? =
        takes.lastOrNull { it.leadsTo(target) && it.milliseconds > after }?.also(takes::remove)

    /**
     * Keeps [take]. When there are too many, the one goes that another is nearest to; the one that has come furthest
     * always stays.
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

    /** From [take] on the run goes on differently: what has come further is of no use any more. */
    fun closeAfter(take: SessionCursor) {
        val late = takes.filter {
            it.milliseconds > take.milliseconds || it.applied > take.applied ||
                it.session.isPaused
        }
        late.forEach(SessionCursor::close)
        takes.removeAll(late)
    }

    /** Closes all there are. */
    fun closeAll() {
        close()
        takes.clear()
    }

    fun close() = takes.forEach(SessionCursor::close)

    private companion object {
        /** Each may hold a ROM log of 40 MB. */
        const val MAX = 3
    }
}
