package robotran.simulation.robot

import robotran.brick.controls.MotorPort
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
import kotlin.math.abs
import kotlin.math.floor

/** The ports of an RCX. Its sensors are measured as often as the firmware reads them. */
internal class RcxPorts(
    private val place: RobotPlacement,
    override val brick: RcxBrick,
    private val machine: SimulatedRobot,
    private val light: LightReading,
    private val thermometer: Thermometer,
    streams: NoiseStreams,
    private val realism: Double,
) : BrickPorts {
    private val lightNoise = streams.named("light sensor: noise")
    private val temperatureNoise = streams.named("temperature sensor: noise")

    override val lightBias = realism * Realism.LIGHT_BIAS * streams.named("light sensor: bias").normal()

    /** The ports whose touch sensor the user presses. */
    private val pressed = BooleanArray(SensorCode.PORTS)
    private var temperature = Double.NaN
    private var temperatureRaw = SensorCode.OPEN_RAW
    private var millivolts = 0

    override fun touch(port: Int, pressed: Boolean) {
        if (port in this.pressed.indices) this.pressed[port] = pressed
    }

    override fun sense(tick: Long) {
        if (tick % SensorCode.READING_MILLISECONDS != 0L) return
        measure()
        val now = floor(machine.battery.volts * MILLIVOLTS_PER_VOLT).toInt()
        if (realism > 0 && abs(now - millivolts) >= MILLIVOLT_TOLERANCE) {
            millivolts = now
            brick.setBattery(now)
        }
    }

    override fun moveMotors(tick: Long) =
        machine.tick(brick.motor(MotorPort.A), brick.motor(MotorPort.B), brick.motor(MotorPort.C), tick)

    private fun measure() {
        for (port in place.ports.indices) {
            if (place.ports[port].isEmpty()) continue
            val sensors = place.ports[port]
            var raw = SensorCode.OPEN_RAW
            for (number in sensors.indices) raw = minOf(raw, raw(sensors[number], port))
            brick.setRawSensorValue(port, raw)
        }
    }

    private fun raw(sensor: PortSensor, port: Int): Int = when (sensor) {
        PortSensor.LEFT_BUMPER -> TouchSensor.raw(machine.isClosed(BumperSide.LEFT))
        PortSensor.RIGHT_BUMPER -> TouchSensor.raw(machine.isClosed(BumperSide.RIGHT))
        PortSensor.TOUCH -> TouchSensor.raw(pressed[port])
        PortSensor.LIGHT -> rounded(light.raw(brick.sensorIsActive(port)) + lightNoise())
        PortSensor.LEFT_ROTATION -> rotation(machine.leftWheel, port)
        PortSensor.RIGHT_ROTATION -> rotation(machine.rightWheel, port)
        PortSensor.TEMPERATURE -> temperature(thermometer.celsius())
    }

    private fun lightNoise() = if (realism == 0.0) {
        0.0
    } else {
        lightBias + realism * Realism.LIGHT_NOISE * lightNoise.normal()
    }

    private fun rotation(wheel: Wheel, port: Int): Int {
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
        const val MILLIVOLTS_PER_VOLT = 1000

        /** Half of the resolution of the brick's converter. */
        const val MILLIVOLT_TOLERANCE = 14
    }
}
