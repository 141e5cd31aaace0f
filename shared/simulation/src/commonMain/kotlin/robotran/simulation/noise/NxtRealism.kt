package robotran.simulation.noise

/**
 * The sizes of the deviations that only a robot with an NXT has, at a realism of 1, beside those of [Realism]. They scale
 * with realism.
 */
internal object NxtRealism {
    /** The play between a motor and its wheel, in degrees: builders tell of 3 to 8. */
    const val LEAST_PLAY = 3.0
    const val MOST_PLAY = 8.0

    /** Most that motors draw together, in motors that run free: 2 A, by the fuse of the brick. */
    const val MAX_CURRENT = 12.0

    /** Min voltage of the batteries, in volts. */
    const val EMPTY_BATTERY = 6.0

    /** Standard deviation of a light sensor's bias and of the noise in each reading, in percent. */
    const val LIGHT_BIAS = 0.8
    const val LIGHT_NOISE = 0.4

    /** Standard deviation of the noise of a sound sensor, in percent. */
    const val SOUND_NOISE = 1.0

    /** Standard deviation of the noise in each colour of a colour sensor, in parts of 255. */
    const val COLOUR_NOISE = 4.0

    /** Standard deviation of an ultrasonic sensor's bias and of the noise in each reading, in centimetres. */
    const val SONAR_BIAS = 1.0
    const val SONAR_NOISE = 0.6

    /** By how much it reads too far what is nearer than [robotran.world.Sonar.NEAR_END], in centimetres. */
    const val SONAR_NEAR_ERROR = 2.0

    /** The part of its readings that are lost by chance. */
    const val SONAR_STRAY = 0.005

    /** The part of its readings that are wrong of a thing that is too close. */
    const val SONAR_TOO_CLOSE = 0.8

    /** The part of its pings that another sensor disturbs. */
    const val SONAR_CROSSTALK = 0.5

    /** Standard deviation of a compass, in degrees, and of a gyro, in degrees a second. */
    const val COMPASS_NOISE = 1.0
    const val GYRO_NOISE = 1.0

    /** The same of an acceleration sensor, in parts of the acceleration of a falling thing. */
    const val ACCELERATION_NOISE = 0.01

    /** The same of an optical distance sensor, in centimetres. */
    const val OPTICAL_NOISE = 0.3

    /** The same of the temperature sensor of an NXT, in degrees Celsius. */
    const val TEMPERATURE_NOISE = 0.05

    /** The same of each eye of an infrared seeker, in the units of light. */
    const val SEEKER_NOISE = 0.002
}
