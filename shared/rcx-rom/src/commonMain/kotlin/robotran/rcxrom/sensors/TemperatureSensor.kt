package robotran.rcxrom.sensors

import kotlin.math.abs

/** The LEGO temperature sensor as something that a port measures: the other way round what the ROM makes of it. */
object TemperatureSensor {
    /** What it can tell, in degrees Celsius. */
    val RANGE = -20.0..69.0

    private const val TENTHS = 10
    private val READABLE = 290..927

    /** The raw value of which the ROM makes what is nearest to [celsius]; beyond [RANGE] that of its nearest end. */
    fun raw(celsius: Double): Int {
        val tenths = celsius.coerceIn(RANGE) * TENTHS
        return READABLE.minBy { abs(SensorReading.celsius(it) - tenths) }
    }
}
