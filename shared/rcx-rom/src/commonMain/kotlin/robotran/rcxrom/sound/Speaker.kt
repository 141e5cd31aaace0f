package robotran.rcxrom.sound

import robotran.brick.sound.SoundEvent
import robotran.brick.sound.SoundTrack
import robotran.brick.sound.ToneRequest
import robotran.brick.state.Screen
import robotran.rcxrom.clock.Clock
import robotran.rcxrom.memory.RcxMemory

/**
 * The loudspeaker and its sound queue, in the ROM's own ring buffer in memory. Like the ROM it checks every ten
 * milliseconds for the next note. Source of the addresses: brickEmu's ROM re-implementation.
 *
 * @param clock the brick's clock.
 * @param drawn what the display shows.
 */
internal class Speaker(private val memory: RcxMemory, private val clock: Clock, private val drawn: () -> Screen) {
    val track = SoundTrack()
    private var notesToPlay: List<Note> = emptyList()

    /** Which slots of the ring hold a sound of the firmware, and whether the current notes belong to one. */
    private val firmwareSlots = BooleanArray(RING_SLOTS)
    private var playsFirmwareSound = false

    /** How the program asked for the sound in each slot of the ring, and for the current notes. */
    private val requests = arrayOfNulls<ToneRequest>(RING_SLOTS)
    private var requestOfNotes: ToneRequest? = null
    private var isFirmwareRequest = false

    /** Whether a tone is audible now; false in a pause. */
    var sounding = false
        private set

    /** Number of queued sounds, 0..[QUEUE_CAPACITY]. */
    val waitingCount: Int get() = (place(QUEUE_TAIL) - place(QUEUE_HEAD) + RING_SLOTS) % RING_SLOTS

    /** Runs [work] and marks its sounds as the firmware's own. */
    fun asFirmware(work: () -> Unit) {
        isFirmwareRequest = true
        work()
        isFirmwareRequest = false
    }

    /** Queues [sound]. Returns false if the queue is full and the sound is lost. */
    fun enqueue(sound: Sound): Boolean {
        if (waitingCount == QUEUE_CAPACITY) return false
        val tail = place(QUEUE_TAIL)
        memory.writeByte(QUEUE_KINDS + tail, sound.kind)
        memory.writeByte(QUEUE_VALUES + tail, sound.value)
        memory.writeByte(QUEUE_CONTROLS + tail, sound.control)
        firmwareSlots[tail] = isFirmwareRequest
        requests[tail] = if (isFirmwareRequest) null else ToneRequest(clock.milliseconds(), drawn())
        memory.writeByte(QUEUE_TAIL, (tail + 1) % RING_SLOTS)
        memory.writeByte(PLAYING_FLAG, 1)
        return true
    }

    /** Discards all other sounds, including the current one, and starts [sound]. */
    fun playNow(sound: Sound) {
        silence()
        enqueue(sound)
    }

    /** Discards all sounds, including the current one. */
    fun silence() {
        if (sounding) track.add(SoundEvent.Cut(clock.milliseconds()))
        sounding = false
        notesToPlay = emptyList()
        memory.writeByte(QUEUE_HEAD, place(QUEUE_TAIL))
        memory.writeByte(REMAINING, 0)
        memory.writeByte(TUNE_FLAG, 0)
        memory.writeByte(PLAYING_FLAG, 0)
    }

    /** Advances by one millisecond. */
    fun tick() {
        if (clock.milliseconds() % LOOK_MILLISECONDS != 0L) return
        val remaining = memory.readByte(REMAINING) - 1
        if (remaining > 0) {
            memory.writeByte(REMAINING, remaining)
        } else {
            if (notesToPlay.isEmpty()) notesToPlay = nextNotes()
            begin(notesToPlay.firstOrNull())
            notesToPlay = notesToPlay.drop(1)
            memory.writeByte(TUNE_FLAG, if (notesToPlay.isEmpty()) 0 else 1)
        }
    }

    private fun nextNotes(): List<Note> {
        if (waitingCount == 0) return emptyList()
        val head = place(QUEUE_HEAD)
        memory.writeByte(QUEUE_HEAD, (head + 1) % RING_SLOTS)
        playsFirmwareSound = firmwareSlots[head]
        firmwareSlots[head] = false
        requestOfNotes = requests[head]
        requests[head] = null
        val value = memory.readByte(QUEUE_VALUES + head)
        return when (val kind = memory.readByte(QUEUE_KINDS + head)) {
            Sound.PAUSE -> listOf(Note(null, value))
            Sound.SYSTEM_SOUND -> SystemSounds.notes(value)
            else -> listOf(Note(ToneTimer.hertz(kind, memory.readByte(QUEUE_CONTROLS + head)), value))
        }
    }

    private fun begin(note: Note?) {
        if (note == null) memory.writeByte(PLAYING_FLAG, 0)
        memory.writeByte(REMAINING, note?.duration ?: 0)
        val hertz = note?.hertz.takeIf { note?.duration != 0 }
        sounding = hertz != null
        if (hertz != null && note != null) {
            val duration = note.duration * LOOK_MILLISECONDS
            track.add(SoundEvent.Tone(clock.milliseconds(), hertz, duration, playsFirmwareSound), requestOfNotes)
        }
    }

    /** A valid index in the ring, even if a program has overwritten it. */
    private fun place(address: Int): Int = memory.readByte(address) % RING_SLOTS

    companion object {
        /** Index of the next free slot, and of the next sound to play. */
        const val QUEUE_TAIL = 0xEFD6
        const val QUEUE_HEAD = 0xEFD7

        /** The three bytes of each slot of the ring, see [Sound]. */
        const val QUEUE_KINDS = 0xEFD8
        const val QUEUE_VALUES = 0xEFE2
        const val QUEUE_CONTROLS = 0xEFEC

        /** Remaining duration of the current note, in [LOOK_MILLISECONDS]. */
        const val REMAINING = 0xEFF6

        /** 1 while a system sound has more notes, otherwise 0. */
        const val TUNE_FLAG = 0xEFFE

        /** 1 while a sound plays or waits, otherwise 0. */
        const val PLAYING_FLAG = 0xEFFF

        const val RING_SLOTS = 10

        /** Nine of the ring's ten slots can be used. */
        const val QUEUE_CAPACITY = RING_SLOTS - 1

        /** The unit of the ROM's durations, and the period of its checks. */
        const val LOOK_MILLISECONDS = 10
    }
}
