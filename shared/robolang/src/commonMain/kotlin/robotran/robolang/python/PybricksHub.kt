package robotran.robolang.python

/**
 * The hubs that run Pybricks.
 *
 * @property word what it is called on the command line and in links.
 * @property className its class in `pybricks.hubs`.
 * @property devices the module with its motors and sensors.
 * @property hasLetters whether its sensors are on ports with letters, as its motors are; otherwise on `S1` and so on.
 * @property hasMatrix whether it has a display of 5 x 5 lights.
 * @property hasScreen whether it has a screen for lines of text.
 * @property motorPorts the letters of its ports for motors.
 * @property stopButton what is set as the button that stops a program, so that the program can ask for the one in the
 * middle; null if that one is free.
 */
enum class PybricksHub(
    val word: String,
    internal val className: String,
    internal val devices: String,
    internal val motorPorts: CharRange,
    internal val hasLetters: Boolean = true,
    internal val hasMatrix: Boolean = false,
    internal val hasScreen: Boolean = false,
    internal val hasSpeaker: Boolean = true,
    internal val hasArrows: Boolean = true,
    internal val stopButton: String? = null,
) {
    PRIME("spike-prime", "PrimeHub", POWERED_UP, 'A'..'F', hasMatrix = true, stopButton = "Button.BLUETOOTH"),
    ESSENTIAL(
        "spike-essential",
        "EssentialHub",
        POWERED_UP,
        'A'..'B',
        hasSpeaker = false,
        hasArrows = false,
        stopButton = NO_BUTTON,
    ),
    TECHNIC(
        "technic-hub",
        "TechnicHub",
        POWERED_UP,
        'A'..'D',
        hasSpeaker = false,
        hasArrows = false,
        stopButton = NO_BUTTON,
    ),
    EV3("ev3", "EV3Brick", "pybricks.ev3devices", 'A'..'D', hasLetters = false, hasScreen = true),
    NXT("nxt-pybricks", "NXTBrick", "pybricks.nxtdevices", 'A'..'C', hasLetters = false, hasScreen = true),
    ;

    /** What a port for a sensor is called in `Port`; [number] counts from 1. */
    internal fun sensorPort(number: Int): String = if (hasLetters) "${'A' + (number - 1)}" else "S$number"

    companion object {
        /** The hub that is called [word]; null if none is. */
        fun of(word: String): PybricksHub? = entries.firstOrNull { it.word == word }
    }
}

private const val POWERED_UP = "pybricks.pupdevices"
private const val NO_BUTTON = "None"
