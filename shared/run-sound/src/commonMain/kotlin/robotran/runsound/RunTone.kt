package robotran.runsound

/**
 * A tone that tells something about a run.
 *
 * @property milliseconds its start in virtual time.
 * @property sign what it tells.
 * @property hertz its pitch, 31 to 20,000.
 * @property duration in milliseconds.
 * @property pan where it is heard: -1 left, 0 in the middle, 1 right.
 * @property loudness 0 to 1.
 */
data class RunTone(
    val milliseconds: Long,
    val sign: RunSign,
    val hertz: Double,
    val duration: Int,
    val pan: Double,
    val timbre: Timbre,
    val loudness: Double,
)

/** What a tone tells. */
enum class RunSign {
    /** A wheel has rolled on by a part of a turn. */
    WHEEL,

    /** How far it is to the next thing ahead, by the pitch, and what the robot drives on, by the timbre. */
    AHEAD,

    /** The robot has bumped into something. */
    BUMP,

    /** A goal is met. */
    GOAL,

    /** A goal can no longer be met. */
    GOAL_LOST,

    /** The program has ended or failed. */
    END,
}

/** The form of the wave of a tone, by which ears tell instruments apart. */
enum class Timbre {
    /** Soft, like a flute. */
    SINE,

    /** Hollow, like the loudspeaker of an RCX. */
    SQUARE,

    /** Sharp, like a buzzer. */
    SAWTOOTH,
}
