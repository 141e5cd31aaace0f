package robotran.robolang.python

/**
 * A robot with a hub that runs Pybricks, as Python has to know it.
 *
 * @property pen the motor of the pen; null if the robot has none.
 * @property wheelDiameter in millimetres.
 * @property track the distance between the middles of the drive wheels, in millimetres.
 * @property gears the teeth of the gears from the motor to the wheel; empty without gears.
 */
data class PybricksRobot(
    val hub: PybricksHub,
    val left: PybricksMotor,
    val right: PybricksMotor,
    val pen: PybricksMotor?,
    val wheelDiameter: Double,
    val track: Double,
    val sensors: List<PybricksSensor>,
    val gears: List<Int> = emptyList(),
) {
    /** Whether a motor can be on [port]: the hub has it, and no sensor is there. */
    internal fun hasMotorPort(port: Char): Boolean =
        port in hub.motorPorts && !(hub.hasLetters && sensors.any { it.port == port - 'A' + 1 })

    companion object {
        private const val WHEEL = 56.0
        private const val TRACK = 112.0

        /** A usual driving base with [hub], and with what its ports have room for. */
        fun defaultFor(hub: PybricksHub): PybricksRobot = when (hub) {
            PybricksHub.PRIME -> PybricksRobot(
                hub,
                LEFT,
                RIGHT,
                PybricksMotor('C'),
                WHEEL,
                TRACK,
                sensors(
                    PybricksSensorKind.COLOR to 4,
                    PybricksSensorKind.FORCE to 5,
                    PybricksSensorKind.ULTRASONIC to 6,
                ),
            )

            PybricksHub.ESSENTIAL -> PybricksRobot(hub, LEFT, RIGHT, null, WHEEL, TRACK, emptyList())

            PybricksHub.TECHNIC -> {
                val sensors = sensors(PybricksSensorKind.COLOR to 4)
                PybricksRobot(hub, LEFT, RIGHT, PybricksMotor('C'), WHEEL, TRACK, sensors)
            }

            PybricksHub.EV3 -> withNumbers(hub, "BCA", PybricksSensorKind.COLOR)

            PybricksHub.NXT -> withNumbers(hub, "ACB", PybricksSensorKind.LIGHT)
        }

        private val LEFT = PybricksMotor('A', isCounterclockwise = true)
        private val RIGHT = PybricksMotor('B')

        /** [motors] are left, right and pen. */
        private fun withNumbers(hub: PybricksHub, motors: String, eye: PybricksSensorKind): PybricksRobot {
            val (left, right, pen) = motors.map { PybricksMotor(it) }
            val touch = PybricksSensorKind.TOUCH
            val sensors = sensors(touch to 1, touch to 2, eye to 3, PybricksSensorKind.ULTRASONIC to 4)
            return PybricksRobot(hub, left, right, pen, WHEEL, TRACK, sensors)
        }

        private fun sensors(vararg all: Pair<PybricksSensorKind, Int>): List<PybricksSensor> =
            all.map { (kind, port) -> PybricksSensor(kind, port) }
    }
}

/**
 * A motor of a robot.
 *
 * @property port its letter.
 * @property isCounterclockwise whether it turns the other way to drive ahead.
 */
data class PybricksMotor(val port: Char, val isCounterclockwise: Boolean = false)

/**
 * A sensor of a robot.
 *
 * @property port counted from 1; on a hub whose ports have letters 1 is A.
 */
data class PybricksSensor(val kind: PybricksSensorKind, val port: Int)

/** The sensors that a program can ask; [className] is its class in Pybricks. */
enum class PybricksSensorKind(internal val className: String) {
    COLOR("ColorSensor"),
    LIGHT("LightSensor"),
    ULTRASONIC("UltrasonicSensor"),
    FORCE("ForceSensor"),
    TOUCH("TouchSensor"),
    SOUND("SoundSensor"),
    ;

    /** Whether a reading of it must be awaited in a task. */
    internal fun isAwaitedOn(hub: PybricksHub): Boolean = when (this) {
        COLOR -> hub != PybricksHub.NXT
        ULTRASONIC, FORCE -> true
        LIGHT, TOUCH, SOUND -> false
    }
}
