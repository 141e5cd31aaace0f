package robotran.simulation.robot

import robotran.brick.sensors.SensorKind
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.TouchSensor
import robotran.rcxrom.state.RcxFirmwareState
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.Realism
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.FingerTouchPart
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.robot.things
import kotlin.math.abs
import kotlin.math.floor

/** The ports of an RCX. Its sensors are measured as often as the firmware reads them. */
internal class RcxPorts(
    robot: RobotDescription,
    override val brick: RcxBrick,
    private val machine: SimulatedRobot,
    lightOf: (SensorPart) -> LightReading,
    thermometer: Thermometer,
    streams: NoiseStreams,
    private val realism: Double,
) : BrickPorts {
    private val lightParts = robot.things.filterIsInstance<SensorPart>().filter { it.sensor == SensorKind.LIGHT }

    /** Of each light sensor, by the part without its port. */
    private val lightEyes: Map<RobotPart, LightEye> = lightParts.indices.associate { number ->
        val name = if (number == 0) "light sensor" else "light sensor ${number + 1}"
        lightParts[number].on(null) to LightEye(lightOf(lightParts[number]), streams, name, realism)
    }
    private val warmth = WarmthEye(thermometer, streams, realism)

    /** What measures on each port. */
    private val sensors: List<List<RawSensor>> = List(SensorCode.PORTS) { port ->
        robot.parts.filter { it.port == port + 1 }.mapNotNull { sensorOf(it, port) }
    }

    override val sensorErrors: SensorErrors =
        robot.parts.filter { it.port != null }.firstNotNullOfOrNull { lightEyes[it.on(null)] }?.let { eye ->
            SensorErrors(lightBias = eye.bias, lightNoise = realism * Realism.LIGHT_NOISE)
        } ?: SensorErrors()

    /** The ports whose touch sensor the user presses. */
    private val pressed = BooleanArray(SensorCode.PORTS)
    private val commands = brick::motor
    private var millivolts = 0

    override val firmwareState: RcxFirmwareState? get() = brick.firmwareState

    override fun memory(): MemorySnapshot = brick.memory()

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

    override fun moveMotors(tick: Long) = machine.tick(tick, command = commands)

    private fun measure() {
        for (port in sensors.indices) {
            val plugged = sensors[port]
            if (plugged.isEmpty()) continue
            var raw = SensorCode.OPEN_RAW
            for (number in plugged.indices) raw = minOf(raw, plugged[number].raw())
            brick.setRawSensorValue(port, raw)
        }
    }

    /** null for what an RCX cannot read. */
    private fun sensorOf(part: RobotPart, port: Int): RawSensor? = when (part) {
        is BumperPart -> machine.bumper(part).let { bumper -> RawSensor { TouchSensor.raw(bumper.isClosed) } }
        is FingerTouchPart -> RawSensor { TouchSensor.raw(pressed[port]) }

        is RotationPart -> {
            val wheel = if (part.wheel == BumperSide.LEFT) machine.leftWheel else machine.rightWheel
            RawSensor { rotationRaw(machine, wheel, brick.sensorIsActive(port)) }
        }

        is SensorPart -> {
            when (part.sensor) {
                SensorKind.LIGHT -> lightEyes.getValue(part.on(null)).let { eye ->
                    RawSensor { roundedRaw(eye.raw(brick.sensorIsActive(port))) }
                }

                SensorKind.TEMPERATURE -> RawSensor { warmth.raw() }
                else -> null
            }
        }
    }

    private companion object {
        const val MILLIVOLTS_PER_VOLT = 1000

        /** Half of the resolution of the brick's converter. */
        const val MILLIVOLT_TOLERANCE = 14
    }
}

/** One sensor on one port. */
private fun interface RawSensor {
    /** Its raw value, alone on the port. */
    fun raw(): Int
}
