package robotran.workshop.sound

import robotran.rcxrom.sound.SoundEvent

/**
 * Fits what a brick plays in virtual time into the real time of a [LoudSpeaker].
 *
 * In real time every tone sounds, with the rhythm it has on the brick, [LEAD] later, whenever exactly the news of it
 * arrive. In slow motion a tone begins when it comes and has its usual pitch and length. In fast motion tones keep
 * pitch and length too, and only those sound that there is room for: a tone that would have to wait for others is
 * dropped. So nothing piles up and nothing screeches.
 */
class SoundPlan(private val speaker: LoudSpeaker) {
    /** The speaker's clock when the brick's is 0; null before the first tone. */
    private var offset: Double? = null
    private var latest: Playing? = null
    private var busyUntil = 0.0

    /** Plans what has happened on the brick since the last call; may be late. */
    fun add(events: List<SoundEvent>) = events.forEach { event ->
        when (event) {
            is SoundEvent.Tone -> play(event)
            is SoundEvent.Cut -> latest?.let { cut(it, event) }
        }
    }

    private fun play(tone: SoundEvent.Tone) {
        val start = placeOf(tone.milliseconds)
        if (start == null) {
            latest = null
            return
        }
        val planned = PlannedTone(start, tone.hertz, tone.durationMilliseconds.toDouble())
        speaker.play(planned)
        busyUntil = planned.end
        latest = Playing(tone.milliseconds, planned)
    }

    /** Shortens the tone to what sounded of it on the brick; one that is over stays as it is. */
    private fun cut(playing: Playing, cut: SoundEvent.Cut) {
        val end = maxOf(speaker.milliseconds, playing.tone.start + (cut.milliseconds - playing.milliseconds))
        if (end < playing.tone.end) {
            speaker.endAt(end)
            busyUntil = end
        }
        latest = null
    }

    /**
     * When what happens on the brick at [milliseconds] is to be heard, on the speaker's clock; null if there is no room
     * for it.
     */
    private fun placeOf(milliseconds: Long): Double? {
        val now = speaker.milliseconds
        val steady = offset?.plus(milliseconds)
        if (steady != null && steady >= now && steady <= now + MAX_AHEAD) return steady
        val isTooEarly = steady != null && steady > now
        if (isTooEarly && busyUntil > now + LEAD) return null
        offset = now + LEAD - milliseconds
        return now + LEAD
    }

    /** @property milliseconds when the tone began on the brick. */
    private class Playing(val milliseconds: Long, val tone: PlannedTone)

    companion object {
        /**
         * Milliseconds between the news of a tone and its begin: as much as a frame of the screen may be late (about
         * 20) and a speaker may have taken on before it plays it (40). Less than what an eye notices between a picture
         * and its sound.
         */
        const val LEAD = 60.0

        /**
         * Milliseconds: nothing is planned further ahead. In real time a tone only is while the clock stands still
         * because the sound card is being opened, which takes about 200 ms the first time.
         */
        const val MAX_AHEAD = 400.0
    }
}
