package robotran.simulation.explain

/**
 * A cause why a robot deviated in a run, or why its sensors erred.
 *
 * @property robot the robot's name.
 * @property amount the size of the effect, in the unit of [cause].
 * @property sentence the explanation for the pupil.
 */
data class DeviationCause(val robot: String, val cause: Cause, val amount: Double, val sentence: String)

enum class Cause {
    /** The robot was not put down exactly at its start: distance in centimetres. */
    START_POSITION,

    /** The robot was not put down at its exact start heading: degrees, counter-clockwise positive. */
    START_HEADING,

    /** A motor is weaker or stronger than nominal: centimetres that its wheel rolled more, or less if negative. */
    LEFT_STRENGTH,
    RIGHT_STRENGTH,

    /** Speeds fluctuate: how many centimetres more the left wheel rolled than the right one. */
    FLUTTER,

    /** Wheels slip a little on the floor: centimetres lost by both together. */
    SLIP,

    /** Wheels spun without grip, as at a wall: centimetres of both together. */
    SPIN,

    /** The batteries were weaker than fresh ones: centimetres lost by both wheels on average. */
    BATTERY,

    /** The light sensor always measures too high, or too low if negative: raw units. */
    LIGHT_BIAS,

    /** The light sensor's readings are noisy: standard deviation in raw units. */
    LIGHT_NOISE,

    /** The bumper switches bounced: number of bounces. */
    BOUNCE,

    /** Play between the motors of an NXT and their wheels: centimetres that both wheels together did not follow. */
    MOTOR_PLAY,

    /** The ultrasonic sensor always measures too far, or too near if negative: centimetres. */
    SONAR_BIAS,

    /** The ultrasonic sensor's readings are noisy: standard deviation in centimetres. */
    SONAR_NOISE,

    /** The colour sensor's readings are noisy: standard deviation in parts of 255. */
    COLOUR_NOISE,
}
