package robotran.nxt.program

import robotran.nxt.hardware.SensorPort
import robotran.nxt.hardware.SensorPower
import robotran.nxt.hardware.SensorType

/** How leJOS NXJ gets a sensor port ready. */
object SensorSetup {
    /**
     * The calls that its class `SensorPort` makes when a program sets the type of [port], 0..3: the type, the power, and
     * the pins, of which one is the lamp.
     *
     * @param type one of [SensorType].
     */
    fun callsFor(port: Int, type: Int): List<NxtCall> = buildList {
        add(NxtCall.of(NxtNative.SET_TYPE, port, type))
        add(NxtCall.of(NxtNative.SET_POWER_TYPE, port, powerOf(type)))
        if (SensorType.isColour(type)) return@buildList
        for (pin in 0..<SensorPort.PINS) add(NxtCall.of(NxtNative.SET_SENSOR_PIN_MODE, port, pin, OUTPUT))
        for (pin in 0..<SensorPort.PINS) {
            add(
                NxtCall.of(NxtNative.SET_SENSOR_PIN, port, pin, if (isHigh(type, pin)) 1 else 0),
            )
        }
    }

    private fun powerOf(type: Int): Int = when (type) {
        in SensorType.TEMPERATURE..SensorType.ANGLE -> SensorPower.RCX
        SensorType.LOWSPEED_9V -> SensorPower.NINE_VOLTS
        else -> SensorPower.NONE
    }

    private fun isHigh(type: Int, pin: Int): Boolean = when (type) {
        SensorType.LIGHT_ACTIVE, SensorType.SOUND_DB -> pin == 0
        SensorType.SOUND_DBA -> pin == 1
        else -> false
    }

    private const val OUTPUT = 2
}
