package robotran.rcxrom.sound

/**
 * Something the brick's loudspeaker does that can be heard; in the order of time. Who plays them on a real loudspeaker
 * begins each [Tone] at its moment and lets it sound for its duration, unless a [Cut] or another tone comes before.
 *
 * @property milliseconds when it happens, on the brick's clock ([BrickState.milliseconds]): virtual time, whatever the
 * speed of the run.
 */
sealed interface SoundEvent {
    val milliseconds: Long

    /**
     * A tone begins. Pauses are no events: a melody is its tones, each with its own moment.
     *
     * @property hertz the frequency the RCX really gives, after the rounding of its timer; nearly the one asked for. 31
     * to 20,000.
     * @property durationMilliseconds how long it lasts, 10 to 2,550.
     * @property ofFirmware whether the firmware plays it by itself, as when a program has ended; otherwise a program
     * has asked for it.
     */
    data class Tone(
        override val milliseconds: Long,
        val hertz: Double,
        val durationMilliseconds: Int,
        val ofFirmware: Boolean = false,
    ) : SoundEvent

    /** The tone that sounds ends at once, since another sound takes its place or the brick is switched off. */
    data class Cut(override val milliseconds: Long) : SoundEvent
}
