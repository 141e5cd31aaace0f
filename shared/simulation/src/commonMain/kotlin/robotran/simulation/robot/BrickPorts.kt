package robotran.simulation.robot

import robotran.brick.Brick
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.state.RcxFirmwareState

/** Connects a brick with the machine that carries it: sensors at its input ports, motors at its output ports. */
internal interface BrickPorts {
    val brick: Brick

    /** The errors of the sensors that are plugged in. */
    val sensorErrors: SensorErrors

    /** What the brick's firmware knows now; null if it tells nothing, such as leJOS's. */
    val firmwareState: RcxFirmwareState? get() = null

    /** A copy of the brick's memory; null if it has none to look at. */
    fun memory(): MemorySnapshot? = null

    /** Lets the sensors of a brick that has been on for a while measure; call it once, before time passes. */
    fun begin() = Unit

    /** Lets the sensors measure what the brick reads in the millisecond number [tick]; call it before [Brick.tick]. */
    fun sense(tick: Long)

    /** Lets the motors turn for the millisecond number [tick]; call it after [Brick.tick]. */
    fun moveMotors(tick: Long)

    /** Presses or releases the touch sensor that the user holds, on the input port [port], from 0. */
    fun touch(port: Int, pressed: Boolean)
}

/**
 * The errors of the sensors of one robot; 0 for an ideal one and for a kind that it does not have.
 *
 * @property lightBias the constant error of the first light sensor, in the brick's raw units.
 * @property lightNoise standard deviation of its noise, in the same.
 * @property sonarBias the constant error of the first ultrasonic sensor, in centimetres.
 * @property sonarNoise standard deviation of its noise, in the same.
 * @property colourNoise standard deviation of the noise of a colour sensor, in parts of 255.
 */
internal data class SensorErrors(
    val lightBias: Double = 0.0,
    val lightNoise: Double = 0.0,
    val sonarBias: Double = 0.0,
    val sonarNoise: Double = 0.0,
    val colourNoise: Double = 0.0,
)

/** Reads a light sensor. */
internal fun interface LightReading {
    /** Its raw value before noise and rounding, powered if it is [active]. */
    fun raw(active: Boolean): Double
}

/** Measures the temperature around a robot. */
internal fun interface Thermometer {
    fun celsius(): Double
}
