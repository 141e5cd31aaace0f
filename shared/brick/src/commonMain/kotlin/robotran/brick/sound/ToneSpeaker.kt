package robotran.brick.sound

import robotran.brick.state.Screen

/**
 * A loudspeaker that plays one tone at a time; a new one takes the place of the one before.
 *
 * @param drawn what the display shows.
 */
class ToneSpeaker(private val drawn: () -> Screen) {
    private var now = 0L
    private var endsAt = 0L
    private var waitsUntil = 0L
    private var isAudible = false

    /** What it has played. */
    val track: SoundTrack = SoundTrack()
    val isSounding: Boolean get() = isAudible && now < endsAt

    /** Milliseconds that the program waits for the tone. */
    val millisecondsLeft: Int get() = maxOf(0L, waitsUntil - now).toInt()

    /**
     * Begins a tone; none is heard at 0 hertz or below.
     *
     * @param milliseconds below 0: until told otherwise, and nobody waits. At most a minute.
     */
    fun beep(hertz: Int, milliseconds: Int) {
        if (isSounding) track.add(SoundEvent.Cut(now))
        val length = if (milliseconds < 0) LONGEST else minOf(milliseconds, LONGEST)
        endsAt = now + length
        waitsUntil = if (milliseconds < 0) now else endsAt
        isAudible = hertz > 0 && length > 0
        if (isAudible) {
            val pitch = hertz.coerceIn(LOWEST_HERTZ, HIGHEST_HERTZ).toDouble()
            track.add(SoundEvent.Tone(now, pitch, length), ToneRequest(now, drawn()))
        }
    }

    /** Ends the tone. */
    fun stop() {
        if (isSounding) track.add(SoundEvent.Cut(now))
        isAudible = false
        waitsUntil = now
    }

    /** Tells the time. */
    fun tick(milliseconds: Long) {
        now = milliseconds
    }

    private companion object {
        const val LOWEST_HERTZ = 31
        const val HIGHEST_HERTZ = 20_000

        /** A minute. */
        const val LONGEST = 60_000
    }
}
