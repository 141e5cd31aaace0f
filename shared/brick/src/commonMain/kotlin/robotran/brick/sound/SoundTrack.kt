package robotran.brick.sound

import robotran.brick.state.Screen

/**
 * The sounds that a brick's loudspeaker has played. Reading changes nothing, so any number of players can listen: each
 * stores the [total] it has heard and reads the events [since] then. A player that joins late, or skips fast-forwarded
 * sounds, continues from [total]. Only the newest [CAPACITY] events are kept, so memory use is bounded without any
 * player.
 */
class SoundTrack {
    private val kept = ArrayDeque<SoundEvent>()
    private val requests = ArrayDeque<ToneRequest?>()

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

    /** How the program asked for the event with the index [number]; null if it did not, or that is not known any more. */
    fun requestOf(number: Long): ToneRequest? =
        requests.getOrNull((number - total + requests.size).coerceIn(-1L, CAPACITY.toLong()).toInt())

    /** Adds [event], which is not earlier than the last one and for which a program has asked by [request]. */
    fun add(event: SoundEvent, request: ToneRequest? = null) {
        if (kept.size == CAPACITY) {
            kept.removeFirst()
            requests.removeFirst()
        }
        kept.addLast(event)
        requests.addLast(request)
        total++
    }

    companion object {
        /** Number of events kept: ten seconds of the shortest tones. */
        const val CAPACITY = 1_000
    }
}

/**
 * The moment at which a program asked for a tone, which may sound later.
 *
 * @property milliseconds on the brick's clock.
 * @property drawn what the program had drawn on the display, even if nobody could see it yet.
 */
class ToneRequest(val milliseconds: Long, val drawn: Screen)
