@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import robotran.runsound.Timbre
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.PlannedTone
import kotlin.math.abs

/**
 * The browser's audio output. Browsers block sound until the user touches the page. Until then there is no context and
 * sounds are dropped.
 */
internal class WebSpeaker : LoudSpeaker {
    private var context: AudioContext? = null
    private var closed = false
    private val sounding = mutableListOf<SoundingTone>()

    init {
        onEveryTouch(::wake)
    }

    override val milliseconds: Double get() = (context?.currentTime ?: 0.0) * MILLISECONDS_PER_SECOND

    override fun play(tone: PlannedTone) {
        val current = context ?: return
        if (closed || current.state != RUNNING) return
        endAt(tone.start)
        sounding += SoundingTone(current, tone)
    }

    override fun endAt(milliseconds: Double) {
        val now = this.milliseconds
        sounding.removeAll { it.end <= now }
        sounding.forEach { it.endAt(maxOf(now, milliseconds)) }
    }

    override fun silence() = endAt(0.0)

    override fun close() {
        silence()
        closed = true
        context?.close()
        context = null
    }

    private fun wake() {
        if (closed) return
        val current = context ?: newAudioContext() ?: return
        context = current
        if (current.state != RUNNING) current.resume()
    }

    private companion object {
        const val RUNNING = "running"
    }
}

/** A [tone] scheduled in [context]. It fades in and out quickly to avoid clicks. */
private class SoundingTone(private val context: AudioContext, private val tone: PlannedTone) {
    private val oscillator = context.createOscillator()
    private val gain = context.createGain()
    private val panner = if (tone.pan == 0.0) null else newStereoPanner(context)
    private val loudness =
        (tone.volume * (if (tone.timbre == Timbre.SINE) SOFT_LOUDNESS else LOUDNESS) * besidePanner()).toFloat()

    /** The end time in milliseconds. */
    var end = tone.end
        private set

    init {
        val start = tone.start / MILLISECONDS_PER_SECOND
        oscillator.type = when (tone.timbre) {
            Timbre.SINE -> "sine"
            Timbre.SQUARE -> "square"
            Timbre.SAWTOOTH -> "sawtooth"
        }
        oscillator.frequency.value = tone.hertz.toFloat()
        oscillator.connect(gain)
        connectGain()
        gain.gain.setValueAtTime(0f, start)
        gain.gain.linearRampToValueAtTime(loudness, start + RAMP_SECONDS)
        oscillator.start(start)
        fallAt(end)
    }

    /** A tone in the middle goes straight to the loudspeakers. */
    private fun connectGain() {
        if (panner == null) {
            gain.connect(context.destination)
        } else {
            panner.pan.value = tone.pan.toFloat()
            gain.connect(panner)
            panner.connect(context.destination)
        }
    }

    /** Makes up for a panner, near whose middle both ears hear 3 dB less than without one. */
    private fun besidePanner(): Double = if (panner == null) 1.0 else ROOT_OF_TWO - (ROOT_OF_TWO - 1) * abs(tone.pan)

    /** Stops it at this time if that is earlier than its end. */
    fun endAt(milliseconds: Double) {
        if (milliseconds >= end) return
        end = milliseconds
        gain.gain.cancelScheduledValues(milliseconds / MILLISECONDS_PER_SECOND)
        fallAt(milliseconds)
    }

    private fun fallAt(milliseconds: Double) {
        val seconds = milliseconds / MILLISECONDS_PER_SECOND
        gain.gain.setValueAtTime(loudness, seconds)
        gain.gain.linearRampToValueAtTime(0f, seconds + RAMP_SECONDS)
        oscillator.stop(seconds + RAMP_SECONDS)
    }

    private companion object {
        /** A fifth of full volume, since a square wave is loud. */
        const val LOUDNESS = 0.2
        const val SOFT_LOUDNESS = 0.25
        const val RAMP_SECONDS = 0.002
        const val ROOT_OF_TWO = 1.4142135623730951
    }
}

private const val MILLISECONDS_PER_SECOND = 1000.0
