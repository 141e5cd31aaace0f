package robotran.runsound

/** One of the tones that make a sign, [after] the sign's start in milliseconds. */
internal class SignTone(val after: Int, val hertz: Double, val duration: Int)

/** The tones of a sign that is no tick and no distance. */
internal val RunSign.tones: List<SignTone>
    get() = when (this) {
        RunSign.WHEEL, RunSign.AHEAD -> emptyList()

        // Low and short, like a thud.
        RunSign.BUMP -> listOf(SignTone(0, 110.0, 60), SignTone(60, 82.41, 80))

        // Upwards: well done.
        RunSign.GOAL -> listOf(SignTone(0, 783.99, 80), SignTone(90, 1046.5, 80), SignTone(180, 1318.51, 120))

        // Downwards, and sharp.
        RunSign.GOAL_LOST -> listOf(SignTone(0, 311.13, 100), SignTone(110, 233.08, 160))

        // Home to the keynote.
        RunSign.END -> listOf(SignTone(0, 523.25, 100), SignTone(120, 392.0, 100), SignTone(240, 261.63, 180))
    }

internal val RunSign.timbre: Timbre
    get() = when (this) {
        RunSign.BUMP, RunSign.GOAL_LOST -> Timbre.SAWTOOTH
        else -> Timbre.SINE
    }

/** This sign from [start] on. */
internal fun RunSign.from(start: Long, pan: Double): List<RunTone> = tones.map {
    RunTone(start + it.after, this, it.hertz, it.duration, pan, timbre, timbre.loudness)
}

internal val Timbre.loudness: Double
    get() = if (this == Timbre.SINE) SoundValues.SOFT_LOUDNESS else SoundValues.SHARP_LOUDNESS

/** The time that this sign takes. */
internal val RunSign.length: Long get() = tones.maxOfOrNull { it.after + it.duration }?.toLong() ?: 0L
