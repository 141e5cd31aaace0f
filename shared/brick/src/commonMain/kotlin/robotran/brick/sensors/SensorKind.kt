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

    /** The colour sensor of HiTechnic, which sends numbers. */
    HITECHNIC_COLOUR,
    MINDSENSORS_COMPASS,
    HITECHNIC_ACCELERATION,
    MINDSENSORS_ACCELERATION,

    /** The light sensor of an RCX on an NXT, with an adapter cable. */
    RCX_LIGHT,

    /** What sends an RCX messages by infrared light. */
    RCX_LINK,

    /** The sensor of mindsensors that measures distances by infrared light. */
    OPTICAL_DISTANCE,

    /** The temperature sensor of an NXT, which sends numbers; [TEMPERATURE] is that of an RCX. */
    NXT_TEMPERATURE,

    /** The first infrared seeker of HiTechnic. */
    INFRARED_SEEKER,

    /** The second one, which tells light that is sent from other infrared light. */
    INFRARED_SEEKER_2,
    ;

    /** Whether it sees the light or colour of a surface: of the floor below it, or ahead. */
    val seesSurfaces: Boolean get() = this == LIGHT || this == COLOUR || this == HITECHNIC_COLOUR || this == RCX_LIGHT
}

/**
 * A sensor that a program expects at an input port.
 *
 * @property port from 1.
 * @property sourceLine the program's line that says so, from 1; 0 if there is none.
 * @property sourceFile the file of the line; null if the program has only one.
 */
data class ExpectedSensor(val port: Int, val kind: SensorKind, val sourceLine: Int, val sourceFile: String?)
