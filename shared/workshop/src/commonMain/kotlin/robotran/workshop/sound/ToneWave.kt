package robotran.workshop.sound

import robotran.runsound.Timbre
import kotlin.math.PI
import kotlin.math.ceil
import kotlin.math.sin

/**
 * Renders tones as 16-bit samples for [CHANNELS] ears at [SAMPLE_RATE] per second and ear, the left one first. They are
 * square waves, like those of the RCX loudspeaker, sines or saws. The wave has no jumps: it keeps its phase when the tone
 * changes, and fades in and out, and from ear to ear, within [RAMP_MILLISECONDS]. Not thread-safe.
 */
class ToneWave {
    private val planned = ArrayDeque<PlannedTone>()
    private var samples = 0L
    private var phase = 0.0
    private var step = 0.0
    private var loudness = 0.0
    private var volume = 0.0
    private var timbre = Timbre.SQUARE
    private val left = Ear()
    private val right = Ear()

    /** The length of all samples so far. */
    val milliseconds: Double get() = samples * MILLISECONDS_PER_SECOND / SAMPLE_RATE

    /** Whether all further samples are silent. */
    val isSilent: Boolean get() = planned.isEmpty() && loudness == 0.0

    /** Schedules [tone] and ends any overlapping one. */
    fun play(tone: PlannedTone) {
        endAt(tone.start)
        planned.addLast(tone)
    }

    /** Ends the tone at this time and drops all tones that start later. */
    fun endAt(milliseconds: Double) {
        while (planned.isNotEmpty() && planned.last().start >= milliseconds) planned.removeLast()
        val last = planned.lastOrNull() ?: return
        if (last.end > milliseconds) planned[planned.lastIndex] = last.copy(duration = milliseconds - last.start)
    }

    /** Drops all tones; the current one fades out within [RAMP_MILLISECONDS]. */
    fun silence() = planned.clear()

    /** Fills [buffer], whose size is even, with the next samples. */
    fun fill(buffer: ShortArray) {
        var place = 0
        val size = buffer.size / CHANNELS
        while (place < size) {
            val now = milliseconds
            while (planned.isNotEmpty() && planned.first().end <= now) planned.removeFirst()
            val next = planned.firstOrNull()
            val sounds = next != null && next.start <= now
            if (next != null && sounds) {
                step = next.hertz / SAMPLE_RATE
                timbre = next.timbre
                left.goal = next.left
                right.goal = next.right
            }
            volume = if (next != null && sounds) next.volume else 0.0
            val change = if (next == null) {
                Double.POSITIVE_INFINITY
            } else if (sounds) {
                next.end
            } else {
                next.start
            }
            val end = if (change.isInfinite()) {
                size
            } else {
                minOf(size.toLong(), place + samplesUntil(change)).toInt()
            }
            write(buffer, place, end)
            place = end
        }
    }

    /** At least one, to guarantee progress. */
    private fun samplesUntil(moment: Double): Long =
        (ceil(moment * SAMPLE_RATE / MILLISECONDS_PER_SECOND - ROUNDING).toLong() - samples).coerceAtLeast(1)

    private fun write(buffer: ShortArray, from: Int, until: Int) {
        for (place in from..<until) {
            left.follow(isSilent = loudness == 0.0)
            right.follow(isSilent = loudness == 0.0)
            loudness = if (loudness < volume) {
                minOf(volume, loudness + RAMP_STEP)
            } else {
                maxOf(volume, loudness - RAMP_STEP)
            }
            val sample = if (loudness == 0.0) 0.0 else wave(phase, step, timbre) * loudness * AMPLITUDE
            buffer[CHANNELS * place] = (sample * left.part).toInt().toShort()
            buffer[CHANNELS * place + 1] = (sample * right.part).toInt().toShort()
            phase += step
            if (phase >= 1.0) phase -= 1.0
        }
        samples += until - from
    }

    /** The [part] of the wave that reaches an ear, on its way to the [goal] unless nothing sounds. */
    private class Ear {
        var goal = 1.0
        var part = 1.0
            private set

        fun follow(isSilent: Boolean) {
            part = when {
                isSilent -> goal
                part < goal -> minOf(goal, part + RAMP_STEP)
                else -> maxOf(goal, part - RAMP_STEP)
            }
        }
    }

    companion object {
        const val SAMPLE_RATE = 44_100

        /** Samples for each moment: those for the left and the right ear. */
        const val CHANNELS = 2

        /** Shorter than the shortest tone, which is ten milliseconds, but long enough to avoid clicks. */
        const val RAMP_MILLISECONDS = 2.0

        private const val MILLISECONDS_PER_SECOND = 1000.0
        private const val RAMP_STEP = MILLISECONDS_PER_SECOND / (RAMP_MILLISECONDS * SAMPLE_RATE)

        /** A fraction of a sample, so that rounding errors do not move a time to the next sample. */
        private const val ROUNDING = 1e-6

        /** A fifth of full volume, since a square wave is loud. */
        private const val AMPLITUDE = 6_500

        /**
         * Above this step the next overtone, the third, exceeds the Nyquist frequency. Only the fundamental remains, a
         * sine.
         */
        private const val HIGHEST_SQUARE_STEP = 1.0 / 6
        private const val FUNDAMENTAL_OF_SQUARE = 4 / PI

        private fun wave(phase: Double, step: Double, timbre: Timbre): Double = when {
            timbre == Timbre.SINE || step >= HIGHEST_SQUARE_STEP -> FUNDAMENTAL_OF_SQUARE * sin(2 * PI * phase)
            timbre == Timbre.SQUARE -> square(phase, step)
            else -> 2 * phase - 1 - edge(phase, step)
        }

        /** High for half a period and low for the other. The edges are rounded (polyBLEP) to prevent aliasing. */
        private fun square(phase: Double, step: Double): Double =
            (if (phase < 0.5) 1.0 else -1.0) + edge(phase, step) - edge((phase + 0.5) % 1.0, step)

        private fun edge(phase: Double, step: Double): Double = when {
            phase < step -> (phase / step).let { it + it - it * it - 1 }
            phase > 1 - step -> ((phase - 1) / step).let { it * it + it + it + 1 }
            else -> 0.0
        }
    }
}
