package robotran.workshop.sound

import robotran.brick.sound.SoundEvent
import robotran.runsound.RunTone
import robotran.runsound.Timbre

/**
 * Schedules a brick's tones, in virtual time, on the real-time clock of a [LoudSpeaker].
 *
 * In real time every tone plays with the brick's rhythm, [LEAD] later, regardless of when its event arrives. In slow
 * motion a tone starts when its event arrives, with its normal pitch and length. In fast motion tones also keep pitch
 * and length; a tone that would have to wait for others is dropped, so tones do not queue up.
 *
 * The tones of a run ([RunTone]) share this time, and never sound while the brick does.
 *
 * @param timbre that of the brick's tones.
 */
class SoundPlan(private val speaker: LoudSpeaker, private val timbre: Timbre = Timbre.SQUARE) {
    /** The speaker's time at the brick's time 0; null before the first tone. */
    private var offset: Double? = null
    private var latest: Playing? = null
    private var busyUntil = 0.0

    /** When the brick's last tone ends. */
    private var brickUntil = 0.0

    /** Schedules the brick's [events] since the last call, and [tones] of the run in the same time. They may arrive late. */
    fun add(events: List<SoundEvent>, tones: List<RunTone> = emptyList()) {
        var next = 0
        for (event in events) {
            while (next < tones.size && tones[next].milliseconds < event.milliseconds) play(tones[next++])
            when (event) {
                is SoundEvent.Tone -> play(event)
                is SoundEvent.Cut -> latest?.let { cut(it, event) }
            }
        }
        while (next < tones.size) play(tones[next++])
    }

    private fun play(tone: RunTone) {
        val start = placeOf(tone.milliseconds) ?: return
        if (start < brickUntil) return
        val planned = tone.plannedAt(start)
        speaker.play(planned)
        busyUntil = planned.end
    }

    private fun play(tone: SoundEvent.Tone) {
        val start = placeOf(tone.milliseconds)
        if (start == null) {
            latest = null
            return
        }
        val volume = tone.volume / FULL_VOLUME
        val planned = PlannedTone(start, tone.hertz, tone.durationMilliseconds.toDouble(), volume, timbre)
        speaker.play(planned)
        busyUntil = planned.end
        brickUntil = planned.end
        latest = Playing(tone.milliseconds, planned)
    }

    /** Shortens the tone to its length on the brick; a finished tone is unchanged. */
    private fun cut(playing: Playing, cut: SoundEvent.Cut) {
        val end = maxOf(speaker.milliseconds, playing.tone.start + (cut.milliseconds - playing.milliseconds))
        if (end < playing.tone.end) {
            speaker.endAt(end)
            busyUntil = end
            brickUntil = end
        }
        latest = null
    }

    /** Converts the brick's time [milliseconds] to the speaker's time; null if there is no room for it. */
    private fun placeOf(milliseconds: Long): Double? {
        val now = speaker.milliseconds
        val steady = offset?.plus(milliseconds)
        if (steady != null && steady >= now && steady <= now + MAX_AHEAD) return steady
        val isTooEarly = steady != null && steady > now
        if (isTooEarly && busyUntil > now + LEAD) return null
        offset = now + LEAD - milliseconds
        return now + LEAD
    }

    /** @property milliseconds the start of the tone on the brick. */
    private class Playing(val milliseconds: Long, val tone: PlannedTone)

    companion object {
        /**
         * The delay in milliseconds between a tone's event and its start: the max delay of a frame (about 20) plus the
         * buffer of a speaker (40). Too short to notice between picture and sound.
         */
        const val LEAD = 60.0

        /**
         * The max time in milliseconds that a tone is scheduled ahead. In real time this only matters while the clock
         * stands still because the sound card is opening, which takes about 200 ms the first time.
         */
        const val MAX_AHEAD = 400.0

        private const val FULL_VOLUME = 100.0
    }
}

/** This tone on the clock of a loudspeaker, from [start] on. */
internal fun RunTone.plannedAt(start: Double) = PlannedTone(start, hertz, duration.toDouble(), loudness, timbre, pan)
