package robotran.brick.sound

/**
 * The sounds that a brick's loudspeaker has played. Reading changes nothing, so any number of players can listen: each
 * stores the [total] it has heard and reads the events [since] then. A player that joins late, or skips fast-forwarded
 * sounds, continues from [total]. Only the newest [CAPACITY] events are kept, so memory use is bounded without any
 * player.
 */
class SoundTrack {
    private val kept = ArrayDeque<SoundEvent>()

    /** Number of events so far. */
    var total: Long = 0L
        private set

    /**
     * The events from index [number], counted from 0 over all events ever, oldest first. The list is immutable. Events
     * that are no longer kept are left out.
     */
    fun since(number: Long): List<SoundEvent> {
        val wanted = (total - number).coerceIn(0L, kept.size.toLong()).toInt()
        return if (wanted == 0) emptyList() else kept.subList(kept.size - wanted, kept.size).toList()
    }

    /** Adds [event], which is not earlier than the last one. */
    fun add(event: SoundEvent) {
        if (kept.size == CAPACITY) kept.removeFirst()
        kept.addLast(event)
        total++
    }

    companion object {
        /** Number of events kept: ten seconds of the shortest tones. */
        const val CAPACITY = 1_000
    }
}
