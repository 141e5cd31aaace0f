package robotran.simulation.robot

import robotran.rcxrom.sensors.RotationSensor
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.TemperatureSensor
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.Realism
import kotlin.math.floor

/** A light sensor with its errors; one object for all ports that it is plugged into. */
internal class LightEye(
    private val light: LightReading,
    streams: NoiseStreams,
    name: String,
    private val realism: Double,
) {
    private val noise = streams.named("$name: noise")

    /** The constant error of this light sensor, in raw units. */
    val bias = realism * Realism.LIGHT_BIAS * streams.named("$name: bias").normal()

    fun raw(active: Boolean): Double = light.raw(active) + error()

    private fun error() = if (realism == 0.0) 0.0 else bias + realism * Realism.LIGHT_NOISE * noise.normal()
}

/** A temperature sensor of an RCX with its errors; one object for all on a robot. */
internal class WarmthEye(private val thermometer: Thermometer, streams: NoiseStreams, private val realism: Double) {
    private val noise = streams.named("temperature sensor: noise")
    private var known = Double.NaN
    private var knownRaw = SensorCode.OPEN_RAW

    /** The temperature, in degrees Celsius. */
    val celsius: Double get() = thermometer.celsius()

    fun raw(): Int {
        val celsius = celsius
        if (celsius != known) {
            known = celsius
            knownRaw = TemperatureSensor.raw(celsius)
        }
        if (realism == 0.0) return knownRaw
        return roundedRaw(knownRaw + realism * Realism.TEMPERATURE_NOISE * noise.normal())
    }
}

/** The raw value of a rotation sensor of an RCX on the axle of [wheel]. */
internal fun rotationRaw(machine: SimulatedRobot, wheel: Wheel, active: Boolean): Int =
    RotationSensor.raw(rotationSteps(machine, wheel), active)

/** The steps of such a sensor, forwards from where the wheel began. */
internal fun rotationSteps(machine: SimulatedRobot, wheel: Wheel): Int {
    val turns = wheel.turned / machine.parameters.wheelCircumference
    return floor(turns * RotationSensor.COUNTS_PER_TURN).toInt()
}

internal fun roundedRaw(raw: Double): Int = floor(raw + HALF).toInt().coerceIn(0, SensorCode.OPEN_RAW)

private const val HALF = 0.5
