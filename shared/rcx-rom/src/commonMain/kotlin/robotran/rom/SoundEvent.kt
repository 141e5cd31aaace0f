package robotran.rom

/**
 * A tone the brick's loudspeaker begins to play; pauses are no events.
 *
 * @property milliseconds when it begins, on the brick's clock.
 * @property hertz the frequency the RCX really gives, after the rounding of its timer; nearly the one asked for.
 * @property durationMilliseconds how long it lasts, unless a later event begins before.
 */
data class SoundEvent(
    val milliseconds: Long,
    val hertz: Double,
    val durationMilliseconds: Int,
)
