package robotran.brick.state

import robotran.brick.sensors.SensorKind

/**
 * What a brick last read at an input port.
 *
 * @property port from 1.
 * @property value the reading in the unit that the program chose.
 * @property isActive whether the port powers its sensor.
 * @property distance the last centimetres of an ultrasonic sensor, or the last reading of another sensor that sends
 * numbers; null if there is none.
 * @property isPressed whether a touch sensor that measured this would be pressed.
 */
interface InputReading {
    val port: Int
    val value: Int
    val isActive: Boolean
    val isPressed: Boolean
    val distance: Int? get() = null

    /**
     * The reading in the unit of a sensor of this [kind], whatever the program chose, where the brick knows it: percent,
     * centimetres, degrees, 0 or 1; otherwise [value]. Null while the sensor is off and measures nothing.
     */
    fun measured(kind: SensorKind): Int? = value
}
