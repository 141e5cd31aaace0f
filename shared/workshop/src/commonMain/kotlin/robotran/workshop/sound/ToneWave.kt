package robotran.workshop.sound

import kotlin.math.PI
import kotlin.math.ceil
import kotlin.math.sin

/**
 * Renders tones as 16-bit mono samples at [SAMPLE_RATE] per second. They are square waves, like those of the RCX
 * loudspeaker, or sines. The wave has no jumps: it keeps its phase when the tone changes, and fades in and out within
 * [RAMP_MILLISECONDS]. Not thread-safe.
 */
class ToneWave {
    private val planned = ArrayDeque<PlannedTone>()
    private var samples = 0L
    private var phase = 0.0
    private var step = 0.0
    private var loudness = 0.0
    private var volume = 0.0
    private var isSoft = false

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

    /** Fills [buffer] with the next samples. */
    fun fill(buffer: ShortArray) {
        var place = 0
        while (place < buffer.size) {
            val now = milliseconds
            while (planned.isNotEmpty() && planned.first().end <= now) planned.removeFirst()
            val next = planned.firstOrNull()
            val sounds = next != null && next.start <= now
            if (next != null && sounds) {
                step = next.hertz / SAMPLE_RATE
                isSoft = next.isSoft
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
                buffer.size
            } else {
                minOf(buffer.size.toLong(), place + samplesUntil(change)).toInt()
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
            loudness = if (loudness < volume) {
                minOf(volume, loudness + RAMP_STEP)
            } else {
                maxOf(volume, loudness - RAMP_STEP)
            }
            buffer[place] =
                if (loudness == 0.0) 0 else (wave(phase, step, isSoft) * loudness * AMPLITUDE).toInt().toShort()
            phase += step
            if (phase >= 1.0) phase -= 1.0
        }
        samples += until - from
    }

    companion object {
        const val SAMPLE_RATE = 44_100

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

        private fun wave(phase: Double, step: Double, isSoft: Boolean): Double = if (isSoft ||
            step >= HIGHEST_SQUARE_STEP
        ) {
            FUNDAMENTAL_OF_SQUARE * sin(2 * PI * phase)
        } else {
            square(phase, step)
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
