package robotran.workshop.sound

/**
 * What makes a brick's tones heard on this machine. It has a clock of its own, plays each tone at its moment of that
 * clock, and one tone at a time: where a later one begins, an earlier one ends. Every call returns at once; a machine
 * that cannot make sounds stays silent.
 */
interface LoudSpeaker {
    /** The clock, in milliseconds; it never goes back, and may stand still while nothing sounds. */
    val milliseconds: Double

    /** Plays [tone]; forgets whatever was to begin at the same time or later. */
    fun play(tone: PlannedTone)

    /** Ends what sounds at that moment of the clock, and forgets whatever was to begin later. */
    fun endAt(milliseconds: Double)

    /** Is silent at once, and forgets everything. */
    fun silence()

    /** Is silent for good. */
    fun close()
}

/**
 * A tone on the clock of a [LoudSpeaker].
 *
 * @property start when it begins, in milliseconds; one that is over begins at once.
 * @property hertz 31 to 20,000.
 * @property duration in milliseconds.
 */
data class PlannedTone(val start: Double, val hertz: Double, val duration: Double) {
    /** When it ends, in milliseconds. */
    val end: Double get() = start + duration
}

/** For machines, tests and people without sound. */
object NoLoudSpeaker : LoudSpeaker {
    override val milliseconds = 0.0

    override fun play(tone: PlannedTone) = Unit

    override fun endAt(milliseconds: Double) = Unit

    override fun silence() = Unit

    override fun close() = Unit
}
