package robotran.workshop.sound

import robotran.rcxrom.sound.SoundTrack

/** Lets [speaker] play what the brick of a running session plays, unless it is [muted]. */
internal class SoundPlayer(private val speaker: LoudSpeaker) {
    private var track: SoundTrack? = null
    private var plan = SoundPlan(speaker)
    private var heard = 0L

    /** While true nothing is heard, and what is played then is never heard. */
    var muted = false
        set(value) {
            field = value
            if (value) speaker.silence()
        }

    /** Follows another brick from its beginning; the one before falls silent. */
    fun listenTo(track: SoundTrack) {
        if (this.track != null) speaker.silence()
        this.track = track
        plan = SoundPlan(speaker)
        heard = 0L
    }

    /** Plays what is new. */
    fun follow() = catchUp { if (!muted) plan.add(it.since(heard)) }

    /** Ends what sounds; what comes after is heard. */
    fun silence() = speaker.silence()

    /** Leaves out what is new: it passed too quickly to be heard. */
    fun skip() = catchUp { }

    fun close() = speaker.close()

    private fun catchUp(hear: (SoundTrack) -> Unit) {
        val current = track ?: return
        if (current.total == heard) return
        hear(current)
        heard = current.total
    }
}
