package robotran.rcxrom.sensors

import robotran.brick.state.InputReading

/**
 * The firmware's last reading of an input port.
 *
 * @property port 1..3.
 * @property raw 0..1023; lower if more current flows.
 * @property value the result of [mode] for the raw value.
 * @property boolean whether the raw value is low.
 * @property active whether the port is powered, as light and rotation sensors need.
 */
data class SensorState(
    override val port: Int,
    val mode: SensorMode,
    val raw: Int,
    override val value: Int,
    val boolean: Boolean,
    val active: Boolean,
) : InputReading {
    override val isActive: Boolean get() = active
    override val isPressed: Boolean get() = boolean
}
