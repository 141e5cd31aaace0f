package robotran.simulation.robot

import robotran.rcxrom.RcxBrick
import robotran.rcxrom.sensors.RotationSensor
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.TemperatureSensor
import robotran.rcxrom.sensors.TouchSensor
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.Realism
import robotran.world.BumperSide
import robotran.world.PortSensor
import robotran.world.RobotPlacement
import kotlin.math.floor

/** Reads a light sensor. */
internal fun interface LightReading {
    /** Its raw value before noise and rounding, powered if it is [active]. */
    fun raw(active: Boolean): Double
}

/** The sensors on a brick's input ports, measured as often as the firmware reads them. */
internal class InputPorts(
    private val place: RobotPlacement,
    private val brick: RcxBrick,
    streams: NoiseStreams,
    private val realism: Double,
) {
    private val lightNoise = streams.named("light sensor: noise")
    private val temperatureNoise = streams.named("temperature sensor: noise")

    /** The constant error of this light sensor, in raw units. */
    val lightBias = realism * Realism.LIGHT_BIAS * streams.named("light sensor: bias").normal()

    /** The ports whose touch sensor the user presses. */
    private val pressed = BooleanArray(SensorCode.PORTS)
    private var temperature = Double.NaN
    private var temperatureRaw = SensorCode.OPEN_RAW

    /** Presses or releases the touch sensor on [port], from 0. */
    fun touch(port: Int, press: Boolean) {
        if (port in pressed.indices) pressed[port] = press
    }

    /**
     * Measures all ports.
     *
     * @param celsius the temperature.
     */
    fun measure(machine: SimulatedRobot, celsius: Double, light: LightReading) {
        for (port in place.ports.indices) {
            if (place.ports[port].isEmpty()) continue
            val sensors = place.ports[port]
            var raw = SensorCode.OPEN_RAW
            for (number in sensors.indices) raw = minOf(raw, raw(sensors[number], port, machine, celsius, light))
            brick.setRawSensorValue(port, raw)
        }
    }

    private fun raw(
        sensor: PortSensor,
        port: Int,
        machine: SimulatedRobot,
        celsius: Double,
        light: LightReading,
    ): Int = when (sensor) {
        PortSensor.LEFT_BUMPER -> TouchSensor.raw(machine.isClosed(BumperSide.LEFT))
        PortSensor.RIGHT_BUMPER -> TouchSensor.raw(machine.isClosed(BumperSide.RIGHT))
        PortSensor.TOUCH -> TouchSensor.raw(pressed[port])
        PortSensor.LIGHT -> rounded(light.raw(brick.sensorIsActive(port)) + lightNoise())
        PortSensor.LEFT_ROTATION -> rotation(machine.leftWheel, machine, port)
        PortSensor.RIGHT_ROTATION -> rotation(machine.rightWheel, machine, port)
        PortSensor.TEMPERATURE -> temperature(celsius)
    }

    private fun lightNoise() = if (realism == 0.0) {
        0.0
    } else {
        lightBias + realism * Realism.LIGHT_NOISE * lightNoise.normal()
    }

    private fun rotation(wheel: Wheel, machine: SimulatedRobot, port: Int): Int {
        val count = floor(wheel.turned / machine.figures.wheelCircumference * RotationSensor.COUNTS_PER_TURN).toInt()
        return RotationSensor.raw(count, brick.sensorIsActive(port))
    }

    private fun temperature(celsius: Double): Int {
        if (celsius != temperature) {
            temperature = celsius
            temperatureRaw = TemperatureSensor.raw(celsius)
        }
        return if (realism == 0.0) {
            temperatureRaw
        } else {
            rounded(temperatureRaw + realism * Realism.TEMPERATURE_NOISE * temperatureNoise.normal())
        }
    }

    private fun rounded(raw: Double): Int = floor(raw + HALF).toInt().coerceIn(0, SensorCode.OPEN_RAW)

    private companion object {
        const val HALF = 0.5
    }
}
