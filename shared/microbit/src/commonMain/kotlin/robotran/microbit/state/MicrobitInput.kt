package robotran.microbit.state

import robotran.brick.sensors.SensorKind
import robotran.brick.state.InputReading
import robotran.microbit.buggy.MicrobitSensor

/**
 * A port of a buggy.
 *
 * @property sensor what is there; null if nothing is.
 * @property value percent of light, or centimetres; 0 without a sensor.
 */
data class MicrobitInput(override val port: Int, val sensor: MicrobitSensor? = null, override val value: Int = 0) :
    InputReading {
    override val isActive: Boolean get() = sensor != null
    override val isPressed: Boolean get() = false
    override val distance: Int? get() = value.takeIf { sensor is MicrobitSensor.Sonar }

    override fun measured(kind: SensorKind): Int? = value.takeIf { sensor != null }
}
