package robotran.rcxrom.sound

/**
 * Everything a brick's loudspeaker has played. Looking changes nothing, so any number of players can listen: each
 * remembers the [total] it has heard up to, and asks for what came [since]. Who comes late, or does not want to hear
 * what passed in fast motion, goes on from [total]. Only the newest [CAPACITY] events are kept, so a player that is
 * never there costs nothing.
 */
class SoundTrack {
    private val kept = ArrayDeque<SoundEvent>()

    /** How many events there have been so far. */
    var total: Long = 0L
        private set

    /**
     * The events from [number] on, counted from 0 over all events ever, the oldest first; a list that never changes.
     * What is no longer kept is left out.
     */
    fun since(number: Long): List<SoundEvent> {
        val wanted = (total - number).coerceIn(0L, kept.size.toLong()).toInt()
        return if (wanted == 0) emptyList() else kept.subList(kept.size - wanted, kept.size).toList()
    }

    internal fun add(event: SoundEvent) {
        if (kept.size == CAPACITY) kept.removeFirst()
        kept.addLast(event)
        total++
    }

    companion object {
        /** How many events are kept: ten seconds of the shortest tones. */
        const val CAPACITY = 1_000
    }
}
