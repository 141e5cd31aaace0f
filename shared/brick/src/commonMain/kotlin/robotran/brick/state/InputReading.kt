package robotran.brick.state

/**
 * What a brick last read at an input port.
 *
 * @property port from 1.
 * @property value the reading in the unit that the program chose.
 * @property isActive whether the port powers its sensor.
 * @property isPressed whether a touch sensor that measured this would be pressed.
 */
interface InputReading {
    val port: Int
    val value: Int
    val isActive: Boolean
    val isPressed: Boolean
}
