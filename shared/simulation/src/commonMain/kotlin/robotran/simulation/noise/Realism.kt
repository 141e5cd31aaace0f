package robotran.simulation.noise

/**
 * How much a robot strays at a realism of 1; at less, so much less. Figures without a source are chosen so that a pupil
 * sees what they do within a sheet of paper, at 1 as with a robot built in a hurry.
 */
internal object Realism {
    /**
     * Standard deviation of a motor's strength, as a part: of two motors of a kit one is usually a few per cent
     * stronger.
     */
    const val MOTOR_STRENGTH = 0.04

    /** Standard deviation of how a motor's speed flutters, as a part: as in TRIK Studio's 2D model. */
    const val MOTOR_FLUTTER = 0.0125

    /** Standard deviation of the part of its way that a wheel slips, always to its loss. */
    const val WHEEL_SLIP = 0.02

    /** How often flutter and slip change, in milliseconds. */
    const val CHANGE_MILLISECONDS = 100

    /** By how much at most batteries are down when a session begins, in volts. */
    const val USED_BATTERY = 0.6

    /** What a driven motor at full power takes from the voltage, in volts. */
    const val MOTOR_SAG = 0.1

    /** What a minute of one motor at full power takes from the batteries for good, in volts. */
    const val BATTERY_FADE = 0.05

    /** Standard deviation of a light sensor's bias, in raw units: sensors of a kit differ by one or two per cent. */
    const val LIGHT_BIAS = 6.0

    /** Standard deviation of the noise in each reading of a light sensor, in raw units: as TRIK Studio's 2. */
    const val LIGHT_NOISE = 2.0

    /** The same of a temperature sensor. */
    const val TEMPERATURE_NOISE = 1.0

    /** How long a bumper's switch bounces when it closes or opens, in milliseconds. */
    const val BOUNCE_MILLISECONDS = 12

    /** Standard deviation of where a robot is put down, in centimetres along each axis; twice that is the most. */
    const val START_PLACE = 0.3

    /** Standard deviation of where it looks then, in degrees; twice that is the most. */
    const val START_HEADING = 1.5
}
