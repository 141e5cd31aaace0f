package robotran.brick.sensors

/** The kinds of sensors that a program can expect at an input port. */
enum class SensorKind {
    TOUCH,
    TEMPERATURE,
    LIGHT,
    ROTATION,
    ULTRASONIC,
    SOUND,
    COLOUR,
    COMPASS,
    GYRO,
}

/**
 * A sensor that a program expects at an input port.
 *
 * @property port from 1.
 * @property sourceLine the program's line that says so, from 1; 0 if there is none.
 * @property sourceFile the file of the line; null if the program has only one.
 */
data class ExpectedSensor(val port: Int, val kind: SensorKind, val sourceLine: Int, val sourceFile: String?)
