package robotran.rcxrom.sensors

/**
 * An input port as the firmware read it last.
 *
 * @property port 1..3.
 * @property raw 0..1023: the lower, the more current flows.
 * @property value what [mode] makes of it.
 * @property boolean whether the raw value is low.
 * @property active whether the port is powered, as a light or rotation sensor needs it.
 */
data class SensorState(
    val port: Int,
    val mode: SensorMode,
    val raw: Int,
    val value: Int,
    val boolean: Boolean,
    val active: Boolean,
)
