package robotran.workshop.sound

import robotran.runsound.Timbre

/**
 * Plays a brick's tones on this machine. It has its own clock, plays each tone at its time on that clock, and plays one
 * tone at a time: a later tone ends an earlier one. All calls return at once. Without audio output it stays silent.
 */
interface LoudSpeaker {
    /** The clock in milliseconds. It is monotonic, and may stop while no tone plays. */
    val milliseconds: Double

    /** Plays [tone] and drops all tones that start at the same time or later. */
    fun play(tone: PlannedTone)

    /** Ends the tone at this time and drops all tones that start later. */
    fun endAt(milliseconds: Double)

    /** Stops at once and drops all tones. */
    fun silence()

    /** Stops permanently. */
    fun close()
}

/**
 * A tone on the clock of a [LoudSpeaker].
 *
 * @property start the start in milliseconds; a past one means now.
 * @property hertz 31 to 20,000.
 * @property duration in milliseconds.
 * @property volume 0 to 1.
 * @property timbre the square wave of an RCX, or another; a brick whose loudspeaker plays samples has a sine.
 * @property pan where it is heard: -1 left, 1 right, 0 in the middle, where it is as loud in both ears as without.
 */
data class PlannedTone(
    val start: Double,
    val hertz: Double,
    val duration: Double,
    val volume: Double = 1.0,
    val timbre: Timbre = Timbre.SQUARE,
    val pan: Double = 0.0,
) {
    /** The end in milliseconds. */
    val end: Double get() = start + duration

    /** The part of it that reaches the left and the right ear, 0 to 1. */
    val left: Double get() = minOf(1.0, 1.0 - pan)
    val right: Double get() = minOf(1.0, 1.0 + pan)
}

/** Plays nothing, for machines without sound and tests. */
object NoLoudSpeaker : LoudSpeaker {
    override val milliseconds = 0.0

    override fun play(tone: PlannedTone) = Unit

    override fun endAt(milliseconds: Double) = Unit

    override fun silence() = Unit

    override fun close() = Unit
}
