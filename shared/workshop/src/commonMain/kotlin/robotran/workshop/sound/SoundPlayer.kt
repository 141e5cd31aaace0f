package robotran.workshop.sound

import robotran.brick.kind.BrickKind
import robotran.brick.sound.SoundTrack

/** Plays the sounds of a session's brick on [speaker] unless [muted]. */
internal class SoundPlayer(private val speaker: LoudSpeaker) {
    private var track: SoundTrack? = null
    private var plan = SoundPlan(speaker)
    private var heard = 0L

    /** While true no sound plays. Sounds in this time are dropped. */
    var muted = false
        set(value) {
            field = value
            if (value) speaker.silence()
        }

    /** Stops the sound and follows another [brick] from its start. */
    fun listenTo(track: SoundTrack, brick: BrickKind) {
        if (this.track != null) speaker.silence()
        this.track = track
        plan = SoundPlan(speaker, isSoft = brick.hasSoftSound)
        heard = 0L
    }

    /** Plays new sounds. */
    fun follow() = catchUp { if (!muted) plan.add(it.since(heard)) }

    /** Plays a short tune now, unless [muted]. */
    fun playTune() {
        if (muted) return
        var start = speaker.milliseconds
        for ((hertz, duration) in TUNE) {
            speaker.play(PlannedTone(start, hertz, duration * PART_OF_TONE))
            start += duration
        }
    }

    /** Stops the current tone; later ones play. */
    fun silence() = speaker.silence()

    /** Drops new sounds, which passed too fast to play. */
    fun skip() = catchUp { }

    fun close() = speaker.close()

    private fun catchUp(setSound: (SoundTrack) -> Unit) {
        val current = track ?: return
        if (current.total == heard) return
        setSound(current)
        heard = current.total
    }

    private companion object {
        /** C, E, G and the next C, in hertz, with their milliseconds. */
        val TUNE = listOf(523.25 to 120.0, 659.25 to 120.0, 783.99 to 120.0, 1046.5 to 260.0)

        /** A short rest separates the tones. */
        const val PART_OF_TONE = 0.9
    }
}
