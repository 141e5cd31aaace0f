package robotran.hub.state

import robotran.brick.sensors.SensorKind
import robotran.brick.state.InputReading
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubPort
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode

/**
 * A port for sensors.
 *
 * @property place which port it is.
 * @property kind the sensor that is plugged in; null if there is none.
 * @property reading what it measures; null if there is none.
 * @property isActive whether a program has made it.
 * @property lightMode what [value] of a sensor of light is.
 */
data class HubInput(
    override val port: Int,
    val place: HubPort,
    val kind: HubDeviceKind? = null,
    val reading: HubReading? = null,
    override val isActive: Boolean = false,
    val lightMode: LightMode = LightMode.REFLECTION,
) : InputReading {
    /** Percent of light or sound, millimetres, or tenths of a newton; 0 without a sensor. */
    override val value: Int
        get() = when (reading) {
            null -> 0
            is HubReading.Light -> reading.brightness(lightMode)
            is HubReading.Distance -> reading.millimetres
            is HubReading.Force -> reading.decinewtons
            is HubReading.Sound -> reading.intensity
        }

    override val isPressed: Boolean get() = (reading as? HubReading.Force)?.isTouched == true

    override val distance: Int? get() = (reading as? HubReading.Distance)?.let { it.millimetres / MILLIMETRES }

    override fun measured(kind: SensorKind): Int? = when (kind) {
        SensorKind.TOUCH -> if (isPressed) 1 else 0
        SensorKind.ULTRASONIC -> distance
        else -> value
    }

    private companion object {
        const val MILLIMETRES = 10
    }
}
