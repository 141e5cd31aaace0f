package robotran.hub.hardware

import robotran.brick.sound.SoundEvent
import robotran.brick.sound.SoundTrack
import robotran.brick.sound.ToneRequest
import robotran.hub.display.HubScreen

/** The loudspeaker: one tone at a time, a new one takes the place of the one before. */
internal class HubSpeaker(private val drawn: () -> HubScreen) {
    private var now = 0L
    private var endsAt = 0L
    private var waitsUntil = 0L
    private var isAudible = false

    val track = SoundTrack()
    val isSounding: Boolean get() = isAudible && now < endsAt

    /** Milliseconds that the program waits for the tone. */
    val millisecondsLeft: Int get() = maxOf(0L, waitsUntil - now).toInt()

    /** @param milliseconds below 0: until told otherwise, and nobody waits. */
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

    fun stop() {
        if (isSounding) track.add(SoundEvent.Cut(now))
        isAudible = false
        waitsUntil = now
    }

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
