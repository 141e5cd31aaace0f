package robotran.nxt.hardware

import robotran.brick.sensors.SensorKind

/** What a program says about a port's sensor: the numbers of leJOS NXJ's `SensorConstants`. */
object SensorType {
    const val NO_SENSOR = 0
    const val SWITCH = 1
    const val TEMPERATURE = 2
    const val REFLECTION = 3
    const val ANGLE = 4
    const val LIGHT_ACTIVE = 5
    const val LIGHT_INACTIVE = 6
    const val SOUND_DB = 7
    const val SOUND_DBA = 8
    const val CUSTOM = 9
    const val LOWSPEED = 10
    const val LOWSPEED_9V = 11
    const val HISPEED = 12
    const val COLOUR_FULL = 13
    const val COLOUR_RED = 14
    const val COLOUR_GREEN = 15
    const val COLOUR_BLUE = 16
    const val COLOUR_NONE = 17

    /** Whether the sensor measures a colour, in its own way instead of by the analog pin. */
    fun isColour(type: Int): Boolean = type in COLOUR_FULL..COLOUR_NONE

    internal fun isKnown(type: Int): Boolean = type in NO_SENSOR..COLOUR_NONE

    internal fun isPercent(type: Int): Boolean = type == REFLECTION || type in LIGHT_ACTIVE..SOUND_DBA

    /** The kind of sensor that a program expects; null if its type does not tell. */
    internal fun kindOf(type: Int): SensorKind? = when (type) {
        SWITCH -> SensorKind.TOUCH
        TEMPERATURE -> SensorKind.TEMPERATURE
        REFLECTION -> SensorKind.RCX_LIGHT
        LIGHT_ACTIVE, LIGHT_INACTIVE -> SensorKind.LIGHT
        ANGLE -> SensorKind.ROTATION
        SOUND_DB, SOUND_DBA -> SensorKind.SOUND
        in COLOUR_FULL..COLOUR_NONE -> SensorKind.COLOUR
        else -> null
    }
}

/** The power of a sensor port. */
object SensorPower {
    /** Only what the pull-up resistor gives. */
    const val NONE = 0

    /** 9 volts, except while the port measures, for sensors of an RCX. */
    const val RCX = 1

    /** 9 volts. */
    const val NINE_VOLTS = 2
}
