package robotran.nxt.hardware

import robotran.brick.sensors.SensorKind
import robotran.brick.state.InputReading

/**
 * A sensor port.
 *
 * @property port 1..4.
 * @property type what the program has said about the sensor: a number of [SensorType].
 * @property power 0 pull-up only, 1 9 volts for sensors of an RCX, 2 9 volts.
 * @property pin0 whether the first digital pin is high; it is the lamp of a light sensor.
 * @property pin1 whether the second digital pin is high.
 * @property raw what the analog pin measures, 0..1023; 1023 if nothing is plugged in.
 * @property colour what a colour sensor measures; null if the program uses none here.
 * @property distance the last centimetres of an ultrasonic sensor that is plugged in, or the reading of another I2C
 * sensor; null if there is none.
 * @property hasMeasured whether that sensor has measured [distance]: not while it is off.
 * @property unitValue what a temperature or rotation sensor of an RCX measures, in degrees; null while it is off.
 */
data class SensorPortState(
    override val port: Int,
    val type: Int,
    val power: Int,
    val pin0: Boolean,
    val pin1: Boolean,
    val raw: Int,
    val colour: NxtColour? = null,
    override val distance: Int? = null,
    val hasMeasured: Boolean = true,
    val unitValue: Int? = null,
) : InputReading {
    /**
     * What the sensor says in the unit of its type: 1 or 0 for a switch, percent for light and sound, the number of a
     * colour, centimetres, otherwise [raw].
     */
    override val value: Int
        get() = when {
            type == SensorType.SWITCH -> if (isPressed) 1 else 0
            SensorType.isPercent(type) -> percent
            colour != null -> colour.kind.code
            distance != null -> distance
            else -> raw
        }

    /** Whether the sensor has power or light. */
    override val isActive: Boolean get() = power != 0 || pin0 || pin1 || colour != null

    override val isPressed: Boolean get() = raw < PRESSED_BELOW

    private val percent: Int get() = (HIGHEST_RAW - raw) * PERCENT / HIGHEST_RAW

    /** Of a colour sensor the mean of its three colours; null while no program uses it. */
    override fun measured(kind: SensorKind): Int? = when (kind) {
        SensorKind.TOUCH -> if (isPressed) 1 else 0
        SensorKind.LIGHT, SensorKind.SOUND, SensorKind.RCX_LIGHT -> percent
        SensorKind.COLOUR -> colour?.run { (red + green + blue) * PERCENT / HIGHEST_SUM }
        SensorKind.ROTATION, SensorKind.TEMPERATURE -> unitValue
        SensorKind.GYRO -> value
        else -> distance.takeIf { hasMeasured }
    }

    private companion object {
        const val HIGHEST_RAW = 1023
        const val HIGHEST_SUM = 3 * HIGHEST_RAW
        const val PERCENT = 100
        const val PRESSED_BELOW = 600
    }
}
