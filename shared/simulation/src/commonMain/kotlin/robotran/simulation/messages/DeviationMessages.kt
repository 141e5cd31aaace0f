package robotran.simulation.messages

/**
 * The sentences of [robotran.simulation.explain.DeviationCause]s in one language; numbers come as text, rounded as they
 * are to be read.
 */
interface DeviationMessages {
    fun startPlace(centimetres: String): String

    /** @param left whether it looked too far to the left. */
    fun startHeading(degrees: String, left: Boolean): String

    /**
     * @param leftMotor whether it is the left motor, otherwise the right one.
     * @param weak whether it is weaker than it should be, otherwise stronger.
     */
    fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String): String

    /** @param left whether that turned the robot to the left. */
    fun flutter(centimetres: String, degrees: String, left: Boolean): String

    fun slip(centimetres: String): String

    fun spin(centimetres: String): String

    fun battery(volts: String, centimetres: String): String

    /** @param dark whether everything looks darker to it than it is. */
    fun lightBias(raw: String, dark: Boolean): String

    fun lightNoise(raw: String): String

    fun bounce(times: Int): String
}
