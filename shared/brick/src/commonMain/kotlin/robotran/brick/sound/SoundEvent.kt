package robotran.brick.sound

/**
 * An audible event of the brick's loudspeaker, in order of time. A player starts each [Tone] at its time and plays it
 * for its duration, unless a [Cut] or another tone comes earlier.
 *
 * @property milliseconds its time on the brick's clock ([BrickState.milliseconds]): virtual time, at any run speed.
 */
sealed interface SoundEvent {
    val milliseconds: Long

    /**
     * A tone starts. Pauses are no events: a melody is its tones, each with its own time.
     *
     * @property hertz the real frequency, after the rounding of an RCX's timer close to the requested one. 31 to 20,000.
     * @property durationMilliseconds 10 to 2,550 on an RCX.
     * @property isFirmware whether the firmware plays it, such as after a program has ended, rather than the program.
     * @property volume 0..100 percent; an RCX is always at full volume.
     */
    data class Tone(
        override val milliseconds: Long,
        val hertz: Double,
        val durationMilliseconds: Int,
        val isFirmware: Boolean = false,
        val volume: Int = 100,
    ) : SoundEvent

    /** The current tone ends at once, because another sound replaces it or the brick is switched off. */
    data class Cut(override val milliseconds: Long) : SoundEvent
}
