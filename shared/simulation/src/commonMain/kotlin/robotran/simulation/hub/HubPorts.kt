package robotran.simulation.hub

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.sensors.SensorKind
import robotran.hub.HubBrick
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode
import robotran.nxt.hardware.Clock
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.nxt.ColourSensorModel
import robotran.simulation.nxt.Ear
import robotran.simulation.nxt.NxtLightSensorModel
import robotran.simulation.nxt.NxtScene
import robotran.simulation.nxt.SensorPlace
import robotran.simulation.nxt.SonarBeam
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.SensorErrors
import robotran.simulation.robot.SimulatedRobot
import robotran.world.BumperPart
import robotran.world.FingerTouchPart
import robotran.world.LightFacing
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.pluggedMotors
import robotran.world.robot.things
import kotlin.math.floor

/**
 * The ports of a hub with Pybricks: motors with their counters, and sensors. On the usual base of SPIKE the left motor is
 * mounted the other way round.
 *
 * @param number the robot's index in the world.
 * @param facing the direction of light sensors that have none of their own.
 */
internal class HubPorts(
    private val robot: RobotDescription,
    override val brick: HubBrick,
    private val scene: NxtScene,
    private val number: Int,
    private val facing: LightFacing,
    private val streams: NoiseStreams,
    private val realism: Double,
) : BrickPorts {
    private val machine: SimulatedRobot = scene.machines[number]
    private val model = brick.model
    private val motors = robot.brick.motorPorts.filter { it in robot.pluggedMotors }
    private val mirrored = robot.drive.left.takeIf { model.mirrorsLeft }
    private val pressed = BooleanArray(robot.brick.inputPorts)
    private var sonarBias = 0.0
    private var hasSonar = false
    private var seesColour = false
    private val sensors: List<HubSensor> = model.sensorPorts.indices.mapNotNull { port ->
        robot.parts.firstOrNull { it.port == port + 1 }?.let { plugIn(it, port) }
    }
    private val commands = ::commandOf

    init {
        for (port in motors) brick.plugMotor(port, model.motor)
    }

    override val sensorErrors: SensorErrors = SensorErrors(
        sonarBias = sonarBias,
        sonarNoise = if (hasSonar) realism * NxtRealism.SONAR_NOISE else 0.0,
        colourNoise = if (seesColour) realism * NxtRealism.COLOUR_NOISE else 0.0,
    )

    override fun touch(port: Int, pressed: Boolean) {
        if (port in this.pressed.indices) this.pressed[port] = pressed
    }

    override fun begin() = sense(0)

    override fun sense(tick: Long) {
        for (port in motors) {
            val degrees = machine.motorDegrees(port)
            brick.setMotorDegrees(port, if (port == mirrored) -degrees else degrees)
        }
        brick.setTurned(-machine.body.pose.heading)
        if (tick % SAMPLE_MILLISECONDS != 0L) return
        for (sensor in sensors) sensor.measure()
        if (realism > 0) brick.setBattery(floor(machine.battery.volts * MILLIVOLTS_PER_VOLT).toInt())
    }

    override fun moveMotors(tick: Long) = machine.tick(
        tick,
        brick.isControlled(robot.drive.left) && brick.isControlled(robot.drive.right),
        commands,
    )

    /** The command in the direction that drives the robot ahead. */
    private fun commandOf(port: MotorPort): MotorState {
        val command = brick.motor(port)
        if (port != mirrored) return command
        return when (command.mode) {
            MotorMode.FORWARD -> command.copy(mode = MotorMode.BACKWARD)
            MotorMode.BACKWARD -> command.copy(mode = MotorMode.FORWARD)
            MotorMode.BRAKE, MotorMode.FLOAT -> command
        }
    }

    private fun plugIn(part: RobotPart, index: Int): HubSensor? {
        val kind = robot.deviceOf(part) ?: return null
        val port = model.sensorPorts[index]
        val looksAhead = part is SensorPart && !SensorPlace(machine, part, facing).looksDown
        brick.plugSensor(port, kind, if (looksAhead) LightMode.AMBIENT else LightMode.REFLECTION)
        val read = when (part) {
            is BumperPart -> machine.bumper(part).let { bumper -> { force(bumper.isClosed) } }
            is FingerTouchPart -> ({ force(pressed[index]) })
            is SensorPart -> reader(part)
            else -> null
        } ?: return null
        return HubSensor { brick.measure(port, read()) }
    }

    private fun reader(part: SensorPart): (() -> HubReading)? {
        val place = SensorPlace(machine, part, facing)
        return when (part.sensor) {
            SensorKind.COLOUR -> {
                seesColour = true
                val name = nameOf(part, "colour sensor")
                val eye = ColourSensorModel(scene, place, streams, name, realism)
                val around = ambient(place, name)
                ({ eye.colour().let { HubReading.Light(bright(it.red), bright(it.green), bright(it.blue), around()) } })
            }

            SensorKind.LIGHT -> {
                val name = nameOf(part, "light sensor")
                val eye = NxtLightSensorModel(scene, number, place, streams, name, realism)
                val around = ambient(place, name)
                ({ bright(DARKEST - eye.raw(true)).let { HubReading.Light(it, it, it, around()) } })
            }

            SensorKind.ULTRASONIC -> sonar(part, place)

            SensorKind.SOUND -> {
                val ear = Ear(scene, place, streams, nameOf(part, "sound sensor"), realism)
                ({ HubReading.Sound((DARKEST - ear.raw()) * PERCENT / DARKEST) })
            }

            else -> null
        }
    }

    /** Measures the light that comes to the sensor at [place] without its own, in percent; [name] names its streams. */
    private fun ambient(place: SensorPlace, name: String): () -> Int {
        val eye = NxtLightSensorModel(scene, number, place, streams, "$name without lamp", realism)
        return { (DARKEST - eye.raw(lit = false)) * PERCENT / DARKEST }
    }

    private fun sonar(part: SensorPart, place: SensorPlace): () -> HubReading {
        val clock = Clock { brick.state.milliseconds }
        val beam = SonarBeam(scene, place, streams, nameOf(part, "sonar"), realism, clock)
        sonarBias = beam.bias
        hasSonar = true
        val nothing = if (robot.brick.hasLetteredInputs) HubReading.FAR else HubReading.FAR_OLDER
        return {
            val nearest = beam.of(0).firstOrNull()
            val millimetres = nearest?.let { floor(it * MILLIMETRES + HALF).toInt() } ?: nothing
            HubReading.Distance(minOf(millimetres, nothing))
        }
    }

    /** The name of the streams of a sensor: [name], or with its number if it is not the robot's first of its kind. */
    private fun nameOf(part: SensorPart, name: String): String {
        val alike = robot.things.filter { it.kind == part.kind }
        val index = alike.indexOfFirst { it.on(null) == part.on(null) }
        return if (index <= 0) name else "$name ${index + 1}"
    }

    private fun force(isPressed: Boolean) = HubReading.Force(if (isPressed) PUSHED else 0)

    private fun bright(raw: Int) = raw * HubReading.BRIGHTEST / DARKEST

    private companion object {
        /** How often a hub asks its sensors. */
        const val SAMPLE_MILLISECONDS = 10

        /** Tenths of a newton of a bumper that is pushed in. */
        const val PUSHED = 50
        const val DARKEST = 1023
        const val PERCENT = 100
        const val MILLIMETRES = 10
        const val HALF = 0.5
        const val MILLIVOLTS_PER_VOLT = 1000
    }
}

/** A sensor that tells the hub what it measures. */
private fun interface HubSensor {
    fun measure()
}
