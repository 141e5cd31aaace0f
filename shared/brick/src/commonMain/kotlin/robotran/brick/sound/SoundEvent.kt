package robotran.brick.sound

/**
 * An audible event of the brick's loudspeaker, in order of time. A player starts each [Tone] at its time and plays it
 * for its duration, unless a [Cut] or another tone comes earlier.
 *
 * @property milliseconds its time on the brick's clock ([RcxState.milliseconds]): virtual time, at any run speed.
 */
sealed interface SoundEvent {
    val milliseconds: Long

    /**
     * A tone starts. Pauses are no events: a melody is its tones, each with its own time.
     *
     * @property hertz the real frequency of the RCX after timer rounding, close to the requested one. 31 to 20,000.
     * @property durationMilliseconds 10 to 2,550.
     * @property isFirmware whether the firmware plays it, such as after a program has ended, rather than the program.
     */
    data class Tone(
        override val milliseconds: Long,
        val hertz: Double,
        val durationMilliseconds: Int,
        val isFirmware: Boolean = false,
    ) : SoundEvent

    /** The current tone ends at once, because another sound replaces it or the brick is switched off. */
    data class Cut(override val milliseconds: Long) : SoundEvent
}
