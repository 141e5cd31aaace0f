package robotran.rcxrom.sensors

import robotran.brick.sensors.SensorKind

/** Sensor constants: types, modes and raw values. Sources: leJOS `SensorConstants.java`, `sensors.c`. */
object SensorCode {
    const val TYPE_TOUCH = 1
    const val TYPE_TEMPERATURE = 2
    const val TYPE_LIGHT = 3
    const val TYPE_ROTATION = 4

    const val MODE_RAW = 0x00
    const val MODE_BOOLEAN = 0x20

    /** The initial mode of every port: light in percent. */
    const val MODE_PERCENT = 0x80

    /** The raw value of an open port; the max of the 10-bit converter. */
    const val OPEN_RAW = 1023

    /** The first of the three port codes of the sensor routines. */
    const val FIRST_PORT = 0x1000

    /** The bit of port 1 in the byte of the powered ports; ports 2 and 3 use the next lower bits. */
    const val FIRST_PORT_BIT = 4
    const val ALL_PORT_BITS = 7

    /** Number of input ports of an RCX; indexed from 0 here. */
    const val PORTS = 3

    /** The period in which the firmware reads all ports. */
    const val READING_MILLISECONDS = 3

    /** The kind of sensor with this [type]; null for raw values, which any sensor has, and for other types. */
    fun kindOf(type: Int): SensorKind? = when (type) {
        TYPE_TOUCH -> SensorKind.TOUCH
        TYPE_TEMPERATURE -> SensorKind.TEMPERATURE
        TYPE_LIGHT -> SensorKind.LIGHT
        TYPE_ROTATION -> SensorKind.ROTATION
        else -> null
    }
}
