package robotran.simulation.nxt

import robotran.brick.sensors.SensorKind
import robotran.nxt.NxtBrick
import robotran.nxt.hardware.SensorPower
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.sensors.RotationSensor
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.LightEye
import robotran.simulation.robot.LightReading
import robotran.simulation.robot.SensorErrors
import robotran.simulation.robot.SimulatedRobot
import robotran.simulation.robot.Thermometer
import robotran.simulation.robot.WarmthEye
import robotran.simulation.robot.rotationSteps
import robotran.simulation.robot.roundedRaw
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.FingerTouchPart
import robotran.world.LightFacing
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.robot.things
import kotlin.math.abs
import kotlin.math.floor

/**
 * The ports of an NXT: counters of motors, sensors at analog pins, and devices that send bytes.
 *
 * @param number the robot's index in the world.
 * @param facing the direction of light sensors that have none of their own.
 * @param lightOf what a light sensor of an RCX sees.
 * @param air where links to RCXs send.
 */
internal class NxtPorts(
    private val robot: RobotDescription,
    override val brick: NxtBrick,
    private val scene: NxtScene,
    private val number: Int,
    private val facing: LightFacing,
    private val lightOf: (SensorPart) -> LightReading,
    thermometer: Thermometer,
    air: InfraredAir,
    private val streams: NoiseStreams,
    private val realism: Double,
) : BrickPorts {
    private val machine: SimulatedRobot = scene.machines[number]
    private val pressed = BooleanArray(robot.brick.inputPorts)
    private val commands = brick::motor
    private val motors = robot.brick.motorPorts.toTypedArray()
    private var millivolts = 0
    private var lights = emptyList<NxtLightSensorModel>()
    private var sonars = emptyList<SonarBeam>()
    private var seesColour = false
    private val warmth = WarmthEye(thermometer, streams, realism)
    private val devices = I2cSensors(scene, machine, streams, realism, brick.clock, air, thermometer)

    /** What measures on each port; null if nothing at an analog pin does. */
    private val sensors: List<NxtSensor?> = List(robot.brick.inputPorts) { port ->
        robot.parts.firstOrNull { it.port == port + 1 }?.let { plugIn(it, port) }
    }

    override val sensorErrors: SensorErrors = SensorErrors(
        lightBias = lights.firstOrNull()?.bias ?: 0.0,
        lightNoise = if (lights.isEmpty()) 0.0 else realism * NxtRealism.LIGHT_NOISE * RAW_PER_PERCENT,
        sonarBias = sonars.firstOrNull()?.bias ?: 0.0,
        sonarNoise = if (sonars.isEmpty()) 0.0 else realism * NxtRealism.SONAR_NOISE,
        colourNoise = if (seesColour) realism * NxtRealism.COLOUR_NOISE else 0.0,
    )

    override fun touch(port: Int, pressed: Boolean) {
        if (port in this.pressed.indices) this.pressed[port] = pressed
    }

    override fun begin() {
        sense(0)
        brick.samplePins()
    }

    override fun sense(tick: Long) {
        for (port in motors) brick.setHubDegrees(port, floor(machine.motorDegrees(port) + HALF).toInt())
        if (tick % SAMPLE_MILLISECONDS != 0L) return
        for (port in sensors.indices) sensors[port]?.measure()
        if (realism > 0) measureBattery()
    }

    override fun moveMotors(tick: Long) = machine.tick(
        tick,
        brick.isRegulated(robot.drive.left) && brick.isRegulated(robot.drive.right),
        commands,
    )

    private fun measureBattery() {
        val now = floor(machine.battery.volts * MILLIVOLTS_PER_VOLT).toInt()
        if (abs(now - millivolts) >= MILLIVOLT_TOLERANCE) {
            millivolts = now
            brick.setBattery(now)
        }
    }

    private fun plugIn(part: RobotPart, port: Int): NxtSensor? = when (part) {
        is BumperPart -> {
            val bumper = machine.bumper(part)
            NxtSensor { brick.setAnalog(port, touchRaw(bumper.isClosed)) }
        }

        is FingerTouchPart -> NxtSensor { brick.setAnalog(port, touchRaw(pressed[port])) }

        is RotationPart -> {
            val wheel = if (part.wheel == BumperSide.LEFT) machine.leftWheel else machine.rightWheel
            NxtSensor {
                val steps = rotationSteps(machine, wheel)
                val isOn = isPowered(port)
                brick.setAnalog(port, RotationSensor.raw(steps, isOn), degreesOf(steps).takeIf { isOn })
            }
        }

        is SensorPart -> plugIn(part, port, SensorPlace(machine, part, facing))
    }

    /** Whether a sensor of an RCX gets its 9 volts. */
    private fun isPowered(port: Int) = brick.sensorPort(port).power == SensorPower.RCX

    private fun plugIn(part: SensorPart, port: Int, place: SensorPlace): NxtSensor? = when (part.sensor) {
        SensorKind.LIGHT -> {
            val eye = NxtLightSensorModel(scene, number, place, streams, nameOf(part, "light sensor"), realism)
            lights = lights + eye
            NxtSensor { brick.setAnalog(port, eye.raw(brick.sensorPort(port).pin0)) }
        }

        SensorKind.COLOUR -> {
            val eye = ColourSensorModel(scene, place, streams, nameOf(part, "colour sensor"), realism)
            seesColour = true
            var last = eye.colour()
            NxtSensor {
                // The same object as long as nothing changes, so that the brick need not look closer.
                val now = eye.colour()
                if (now != last) last = now
                brick.setColour(port, last)
            }
        }

        SensorKind.SOUND -> {
            val ear = Ear(scene, place, streams, nameOf(part, "sound sensor"), realism)
            NxtSensor { brick.setAnalog(port, ear.raw()) }
        }

        SensorKind.GYRO -> {
            val gyro = Gyro(machine, streams, nameOf(part, "gyro"), realism)
            NxtSensor { brick.setAnalog(port, gyro.raw()) }
        }

        SensorKind.ULTRASONIC -> {
            val sonar = SonarBeam(scene, place, streams, nameOf(part, "sonar"), realism, brick.clock)
            sonars = sonars + sonar
            scene.sonars += sonar
            brick.connect(port, sonar.device)
            null
        }

        SensorKind.RCX_LIGHT -> {
            val eye = LightEye(lightOf(part), streams, nameOf(part, "RCX light sensor"), realism)
            NxtSensor { brick.setAnalog(port, roundedRaw(eye.raw(isPowered(port)))) }
        }

        SensorKind.TEMPERATURE -> {
            NxtSensor { brick.setAnalog(port, warmth.raw(), floor(warmth.celsius + HALF).toInt()) }
        }

        else -> {
            brick.connect(port, devices.of(part, place) { nameOf(part, it) })
            null
        }
    }

    /** The name of the streams of a sensor: [name], or with its number if it is not the robot's first of its kind. */
    private fun nameOf(part: SensorPart, name: String): String {
        val alike = robot.things.filter { it.kind == part.kind }
        val index = alike.indexOfFirst { it.on(null) == part.on(null) }
        return if (index <= 0) name else "$name ${index + 1}"
    }

    private fun degreesOf(steps: Int) = steps * DEGREES / RotationSensor.COUNTS_PER_TURN

    private fun touchRaw(isPressed: Boolean) = if (isPressed) PRESSED else OPEN

    private companion object {
        const val HALF = 0.5
        const val DEGREES = 360

        /** How often the brick measures its pins. */
        const val SAMPLE_MILLISECONDS = 3

        /** A pressed switch has 2.2 kilohms. */
        const val PRESSED = 183
        const val OPEN = 1023
        const val MILLIVOLTS_PER_VOLT = 1000

        /** Half of the resolution of the brick's converter. */
        const val MILLIVOLT_TOLERANCE = 7
    }
}

/** A sensor at an analog pin. */
private fun interface NxtSensor {
    /** Tells the brick what it measures. */
    fun measure()
}
