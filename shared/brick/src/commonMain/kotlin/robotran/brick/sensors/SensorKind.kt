package robotran.brick.sensors

import robotran.rcxrom.sensors.SensorCode

/**
 * The kinds of sensors that a program can expect at an input port.
 *
 * @property type the code of the kind in the firmware's sensor table. Source: leJOS `SensorConstants.java`.
 */
enum class SensorKind(val type: Int) {
    TOUCH(SensorCode.TYPE_TOUCH),
    TEMPERATURE(SensorCode.TYPE_TEMPERATURE),
    LIGHT(SensorCode.TYPE_LIGHT),
    ROTATION(SensorCode.TYPE_ROTATION),
    ;

    companion object {
        /** The kind with this [type]; null for raw values, which any sensor has. */
        fun of(type: Int): SensorKind? = entries.find { it.type == type }
    }
}

/**
 * A sensor that a program expects at an input port.
 *
 * @property port 1..3.
 * @property sourceLine the program's line that says so, from 1; 0 if there is none.
 * @property sourceFile the file of the line; null if the program has only one.
 */
data class ExpectedSensor(val port: Int, val kind: SensorKind, val sourceLine: Int, val sourceFile: String?)
