package robotran.simulation.robot

import robotran.brick.Brick

/** Connects a brick with the machine that carries it: sensors at its input ports, motors at its output ports. */
internal interface BrickPorts {
    val brick: Brick

    /** The constant error of the light sensor, in the brick's raw units; 0 for an ideal one. */
    val lightBias: Double

    /** Lets the sensors measure what the brick reads in the millisecond number [tick]; call it before [Brick.tick]. */
    fun sense(tick: Long)

    /** Lets the motors turn for the millisecond number [tick]; call it after [Brick.tick]. */
    fun moveMotors(tick: Long)

    /** Presses or releases the touch sensor that the user holds, on the input port [port], from 0. */
    fun touch(port: Int, pressed: Boolean)
}

/** Reads a light sensor. */
internal fun interface LightReading {
    /** Its raw value before noise and rounding, powered if it is [active]. */
    fun raw(active: Boolean): Double
}

/** Measures the temperature around a robot. */
internal fun interface Thermometer {
    fun celsius(): Double
}
