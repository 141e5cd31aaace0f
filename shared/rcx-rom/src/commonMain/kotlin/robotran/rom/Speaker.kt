package robotran.rom

/**
 * The loudspeaker and the sounds that wait for it. Like the ROM it looks for something new to play every ten milliseconds.
 */
internal class Speaker(private val memory: RcxMemory) {
    private val waiting = ArrayDeque<Sound>()
    private var notesToPlay: List<Note> = emptyList()
    private var playing: Note? = null
    private var remainingMilliseconds = 0
    private val events = ArrayDeque<SoundEvent>()

    /** Whether a tone can be heard now; false in a pause. */
    val sounding: Boolean get() = playing?.hertz != null

    /** How many sounds wait, 0..[QUEUE_PLACES]. */
    val waitingCount: Int get() = waiting.size

    /** Lets [sound] wait for its turn; false if the queue is full and the sound is lost. */
    fun enqueue(sound: Sound): Boolean {
        if (waiting.size == QUEUE_PLACES) return false
        waiting.addLast(sound)
        memory.writeByte(PLAYING_FLAG, 1)
        return true
    }

    /** Forgets all other sounds, the one that is played too, and lets [sound] begin. */
    fun playNow(sound: Sound) {
        waiting.clear()
        notesToPlay = emptyList()
        playing = null
        remainingMilliseconds = 0
        enqueue(sound)
    }

    /** One millisecond, the one that ends at [milliseconds]. */
    fun tick(milliseconds: Long) {
        if (milliseconds % LOOK_MILLISECONDS != 0L) return
        remainingMilliseconds -= LOOK_MILLISECONDS
        if (remainingMilliseconds > 0) return
        if (notesToPlay.isEmpty()) notesToPlay = waiting.removeFirstOrNull().orEmpty()
        begin(notesToPlay.firstOrNull(), milliseconds)
        notesToPlay = notesToPlay.drop(1)
    }

    /** The tones begun since the last call, the newest [KEPT_EVENTS] of them. */
    fun takeEvents(): List<SoundEvent> = events.toList().also { events.clear() }

    private fun begin(note: Note?, milliseconds: Long) {
        playing = note
        remainingMilliseconds = note?.durationMilliseconds ?: 0
        if (note == null) memory.writeByte(PLAYING_FLAG, 0)
        if (note?.hertz == null || note.durationMilliseconds == 0) return
        if (events.size == KEPT_EVENTS) events.removeFirst()
        events.addLast(SoundEvent(milliseconds, note.hertz, note.durationMilliseconds))
    }

    companion object {
        /** 1 while a sound is played or waits, otherwise 0. Source: brickEmu. */
        const val PLAYING_FLAG = 0xEFFF

        /** Nine of the ROM's ring of ten places can be used. */
        const val QUEUE_PLACES = 9

        /** The unit of the ROM's durations, and how often it looks whether one is over. */
        const val LOOK_MILLISECONDS = 10

        /** More than ten seconds of the shortest sounds: who takes them less often does not listen. */
        const val KEPT_EVENTS = 1_000
    }
}
