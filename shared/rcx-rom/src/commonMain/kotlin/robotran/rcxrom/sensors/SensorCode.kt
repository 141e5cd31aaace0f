package robotran.rcxrom.sensors

/**
 * The numbers of sensors: types, modes and what the ports measure. Source: leJOS `SensorConstants.java`, `sensors.c`.
 */
object SensorCode {
    const val TYPE_TOUCH = 1
    const val TYPE_LIGHT = 3

    const val MODE_RAW = 0x00
    const val MODE_BOOLEAN = 0x20

    /** What every port begins with: light in percent. */
    const val MODE_PERCENT = 0x80

    /** What an open port measures; the 10-bit converter's largest value. */
    const val OPEN_RAW = 1023

    /** The first of the three codes by which the sensor routines know the ports. */
    const val FIRST_PORT = 0x1000

    /** The bit of port 1 in the byte of the powered ports; the others follow downwards. */
    const val FIRST_PORT_BIT = 4
    const val ALL_PORT_BITS = 7

    /** How many input ports an RCX has; they are numbered from 0 here. */
    const val PORTS = 3

    /** How often the firmware reads all ports, in milliseconds. */
    const val READING_MILLISECONDS = 3
}
