package robotran.simulation.noise

/**
 * The sizes of a robot's deviations at a realism of 1; they scale with realism. Values without a source are chosen so
 * that a pupil sees their effect within a sheet of paper, at 1 as with a hastily built robot.
 */
internal object Realism {
    /**
     * Standard deviation of a motor's relative strength: of two motors of a kit one is usually a few per cent stronger.
     */
    const val MOTOR_STRENGTH = 0.04

    /** Standard deviation of a motor's relative speed fluctuation: as in TRIK Studio's 2D model. */
    const val MOTOR_FLUTTER = 0.0125

    /** Standard deviation of the part of its distance that a wheel loses by slipping. */
    const val WHEEL_SLIP = 0.02

    /** Period in which fluctuation and slip change, in milliseconds. */
    const val CHANGE_MILLISECONDS = 100

    /** What the lag of a buggy's motor is longer by, in milliseconds: they start within 50 to 150 and roll on 0.5 to 2 cm. */
    const val BUGGY_LAG = 30.0

    /** Max voltage loss of the batteries at the start of a session, in volts. */
    const val USED_BATTERY = 0.6

    /** Voltage drop while one motor runs at full power, in volts. */
    const val MOTOR_SAG = 0.1

    /** Permanent voltage loss per minute of one motor at full power, in volts. */
    const val BATTERY_FADE = 0.05

    /** Standard deviation of a light sensor's bias, in raw units: sensors of a kit differ by one or two per cent. */
    const val LIGHT_BIAS = 6.0

    /** Standard deviation of the noise in each light sensor reading, in raw units: TRIK Studio uses 2. */
    const val LIGHT_NOISE = 2.0

    /** The same for a temperature sensor. */
    const val TEMPERATURE_NOISE = 1.0

    /** Bounce time of a bumper's switch when it closes or opens, in milliseconds. */
    const val BOUNCE_MILLISECONDS = 12

    /** Standard deviation of the start position, in centimetres along each axis; the max is twice that. */
    const val START_POSITION = 0.3

    /** Standard deviation of the start heading, in degrees; the max is twice that. */
    const val START_HEADING = 1.5
}
