package robotran.rcxrom.sensors

import kotlin.math.abs

/** The LEGO temperature sensor: the inverse of the ROM's conversion. */
object TemperatureSensor {
    /** Its range in degrees Celsius. */
    val RANGE = -20.0..69.0

    private const val TENTHS = 10
    private val READABLE = 290..927

    /** The raw value that the ROM converts to the temperature closest to [celsius], which is clamped to [RANGE]. */
    fun raw(celsius: Double): Int {
        val tenths = celsius.coerceIn(RANGE) * TENTHS
        return READABLE.minBy { abs(SensorReading.celsius(it) - tenths) }
    }
}
