package robotran.workshop.sound

import robotran.brick.kind.BrickKind
import robotran.brick.sound.SoundEvent
import robotran.brick.sound.SoundTrack
import robotran.runsound.RunTone
import robotran.runsound.Timbre

/** Plays the sounds of a session's brick, and of the run, on [speaker] unless [muted]. */
internal class SoundPlayer(private val speaker: LoudSpeaker) {
    private var track: SoundTrack? = null
    private var plan = SoundPlan(speaker)
    private var heard = 0L
    private var momentUntil = 0.0

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
        plan = SoundPlan(speaker, if (brick.hasSoftSound) Timbre.SINE else Timbre.SQUARE)
        heard = 0L
    }

    /** Plays new sounds, and [tones] of the run since the last call. */
    fun follow(tones: List<RunTone> = emptyList()) {
        val events = newEvents()
        if (!muted && (events.isNotEmpty() || tones.isNotEmpty())) plan.add(events, tones)
    }

    /** Plays [tones] now, unless [muted]. Their times count from now on. */
    fun playTones(tones: List<RunTone>) {
        if (muted) return
        val start = speaker.milliseconds
        for (tone in tones) speaker.play(tone.plannedAt(start + tone.milliseconds))
    }

    /** Plays [tone], the sound of one moment of a run, now, unless [muted] or another moment still sounds. */
    fun playMoment(tone: RunTone) {
        val now = speaker.milliseconds
        if (muted || now < momentUntil) return
        val planned = tone.plannedAt(now)
        momentUntil = planned.end
        speaker.play(planned)
    }

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
    fun skip() {
        heard = track?.total ?: return
    }

    fun close() = speaker.close()

    private fun newEvents(): List<SoundEvent> {
        val current = track ?: return emptyList()
        return current.since(heard).also { heard = current.total }
    }

    private companion object {
        /** C, E, G and the next C, in hertz, with their milliseconds. */
        val TUNE = listOf(523.25 to 120.0, 659.25 to 120.0, 783.99 to 120.0, 1046.5 to 260.0)

        /** A short rest separates the tones. */
        const val PART_OF_TONE = 0.9
    }
}
