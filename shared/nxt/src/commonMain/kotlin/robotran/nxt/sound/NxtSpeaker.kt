package robotran.nxt.sound

import robotran.brick.sound.SoundEvent
import robotran.brick.sound.SoundTrack
import robotran.brick.sound.ToneRequest
import robotran.brick.state.Screen
import robotran.nxt.hardware.Clock

/**
 * The loudspeaker: one sound at a time, a new one takes the place of the one before.
 *
 * @param drawn what the program has drawn on the display.
 */
internal class NxtSpeaker(private val clock: Clock, private val drawn: () -> Screen) {
    val track = SoundTrack()

    /** The menu's volume, 0..[HIGHEST_SETTING]. With [NORMAL_SETTING], programs sound as loud as they ask. */
    var setting = NORMAL_SETTING

    private var endsAt = 0L
    private var volumeNow = 0
    private val samples = ArrayDeque<SampledTone>()
    private var samplesUntil = 0L

    /** Whether a tone plays. */
    val sounding: Boolean get() = volumeNow > 0 && clock.milliseconds() < endsAt

    /** Percent of full volume that can be heard now. */
    val loudness: Int get() = if (sounding) volumeNow else 0

    /** Milliseconds that the sound still takes, with the samples that wait. */
    val millisecondsLeft: Int get() = maxOf(0L, maxOf(endsAt, samplesUntil) - clock.milliseconds()).toInt()

    /**
     * Plays a tone at once.
     *
     * @param hertz clamped to [LOWEST_HERTZ]..[HIGHEST_HERTZ].
     * @param volume 0..100; other values are clamped. With 0 there is silence.
     */
    fun play(hertz: Int, milliseconds: Int, volume: Int, isFirmware: Boolean = false) {
        samples.clear()
        samplesUntil = 0
        begin(hertz, milliseconds.coerceIn(0, LONGEST), volume, isFirmware)
    }

    /**
     * Plays [data], one unsigned byte a sample, after the samples before it. A chunk becomes one tone: as high as the
     * samples cross their middle, as loud as they are.
     *
     * @param rate samples a second, 2,000..22,050; other values are clamped.
     * @return how many samples there was room for.
     */
    fun playSamples(data: ByteArray, rate: Int, volume: Int): Int {
        val perSecond = rate.coerceIn(LOWEST_RATE, HIGHEST_RATE)
        val now = clock.milliseconds()
        val waiting = maxOf(0L, samplesUntil - now)
        val room = (perSecond * maxOf(0L, LONGEST_QUEUE - waiting) / SECOND).toInt()
        val count = minOf(data.size, room)
        if (count == 0) return 0
        val milliseconds = maxOf(1, count * SECOND / perSecond)
        samples += SampledTone(hertzOf(data, count, perSecond), milliseconds, volume * loudness(data, count) / FULL)
        samplesUntil = now + waiting + milliseconds
        if (waiting == 0L) playNextSamples()
        return count
    }

    /** Ends the sound. */
    fun stop() {
        samples.clear()
        samplesUntil = 0
        if (sounding) track.add(SoundEvent.Cut(clock.milliseconds()))
        endsAt = 0
        volumeNow = 0
    }

    fun tick() {
        if (samples.isNotEmpty() && clock.milliseconds() >= endsAt) playNextSamples()
    }

    private fun playNextSamples() {
        val next = samples.removeFirst()
        begin(next.hertz, next.milliseconds, next.volume, isFirmware = false)
    }

    private fun begin(hertz: Int, milliseconds: Int, volume: Int, isFirmware: Boolean) {
        val now = clock.milliseconds()
        val loudness = (volume.coerceIn(0, FULL) * setting / NORMAL_SETTING).coerceAtMost(FULL)
        if (milliseconds == 0 || loudness == 0) {
            if (sounding) track.add(SoundEvent.Cut(now))
            volumeNow = 0
        } else {
            val pitch = hertz.coerceIn(LOWEST_HERTZ, HIGHEST_HERTZ).toDouble()
            val tone = SoundEvent.Tone(now, pitch, milliseconds, isFirmware, loudness)
            track.add(tone, if (isFirmware) null else ToneRequest(now, drawn()))
            volumeNow = loudness
        }
        endsAt = now + milliseconds
    }

    private fun hertzOf(data: ByteArray, count: Int, rate: Int): Int {
        var crossings = 0
        for (index in 1..<count) if (isHigh(data[index]) != isHigh(data[index - 1])) crossings++
        return crossings * rate / (2 * count)
    }

    private fun loudness(data: ByteArray, count: Int): Int {
        var highest = 0
        for (index in 0..<count) highest = maxOf(highest, distance(data[index]))
        return highest * FULL / MIDDLE
    }

    private fun isHigh(sample: Byte): Boolean = sample < 0

    /** How far a sample is from the middle, 128. */
    private fun distance(sample: Byte): Int {
        val value = (sample.toInt() and BYTE) - MIDDLE
        return if (value < 0) -value else value
    }

    private class SampledTone(val hertz: Int, val milliseconds: Int, val volume: Int)

    companion object {
        const val LOWEST_HERTZ = 31
        const val HIGHEST_HERTZ = 20_000
        const val HIGHEST_SETTING = 10
        const val NORMAL_SETTING = 8

        /** A minute. */
        private const val LONGEST = 60_000

        private const val LOWEST_RATE = 2_000
        private const val HIGHEST_RATE = 22_050
        private const val LONGEST_QUEUE = 250L
        private const val SECOND = 1_000
        private const val FULL = 100
        private const val MIDDLE = 128
        private const val BYTE = 0xFF
    }
}
