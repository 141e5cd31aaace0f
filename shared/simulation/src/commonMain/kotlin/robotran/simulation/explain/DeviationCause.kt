package robotran.simulation.explain

/**
 * Something that made a robot stray in a run, or its sensors err.
 *
 * @property robot the robot's name.
 * @property cause what it was.
 * @property amount how much it did, in the unit of [cause].
 * @property sentence the same for a pupil.
 */
data class DeviationCause(val robot: String, val cause: Cause, val amount: Double, val sentence: String)

/** What can make a robot stray. */
enum class Cause {
    /** It was not put down exactly where it should stand: centimetres beside it. */
    START_PLACE,

    /** It was not put down looking exactly where it should: degrees, counter-clockwise positive. */
    START_HEADING,

    /** A motor is weaker or stronger than it should be: centimetres that its wheel rolled more, or less if negative. */
    LEFT_STRENGTH,
    RIGHT_STRENGTH,

    /** Speeds flutter: by how many centimetres more the left wheel rolled than the right one. */
    FLUTTER,

    /** Wheels slip a little on the floor: centimetres lost by both together. */
    SLIP,

    /** Wheels turned without grip, as at a wall: centimetres of both together. */
    SPIN,

    /** The batteries gave less than fresh ones: centimetres lost by both wheels on average. */
    BATTERY,

    /** The light sensor always measures too high, or too low if negative: raw units. */
    LIGHT_BIAS,

    /** Its readings flicker: standard deviation in raw units. */
    LIGHT_NOISE,

    /** The switches of the bumpers bounced: how often. */
    BOUNCE,
}
