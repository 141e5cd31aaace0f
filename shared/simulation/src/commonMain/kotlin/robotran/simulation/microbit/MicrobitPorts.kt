package robotran.simulation.microbit

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.sensors.SensorKind
import robotran.microbit.MicrobitBrick
import robotran.microbit.buggy.MicrobitSensor
import robotran.nxt.hardware.Clock
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.noise.NxtRealism
import robotran.simulation.nxt.Ear
import robotran.simulation.nxt.NxtLightSensorModel
import robotran.simulation.nxt.NxtScene
import robotran.simulation.nxt.SensorPlace
import robotran.simulation.nxt.SonarBeam
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.SensorErrors
import robotran.simulation.robot.SimulatedRobot
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.SensorPart
import kotlin.math.floor

/**
 * Connects a micro:bit with its buggy: the line sensors and the distance sensor that the buggy has, the microphone and
 * the lights of the board, which measure light, too.
 *
 * @param number the robot's index in the world.
 */
internal class MicrobitPorts(
    private val robot: RobotDescription,
    override val brick: MicrobitBrick,
    private val scene: NxtScene,
    private val number: Int,
    private val streams: NoiseStreams,
    private val realism: Double,
) : BrickPorts {
    private val machine: SimulatedRobot = scene.machines[number]
    private var sonarBias = 0.0
    private var hasSonar = false
    private val sensors: List<Measuring> =
        robot.microbitSensors.mapNotNull { (port, sensor) ->
            robot.partFor(port, sensor)?.let { measuring(it, sensor) }
        } +
            own()
    private val commands = ::commandOf

    init {
        brick.plug(robot.microbitSensors)
    }

    override val sensorErrors: SensorErrors = SensorErrors(
        sonarBias = sonarBias,
        sonarNoise = if (hasSonar) realism * NxtRealism.SONAR_NOISE else 0.0,
    )

    override fun touch(port: Int, pressed: Boolean) = Unit

    override fun begin() {
        for (sensor in sensors) sensor.measure()
    }

    override fun sense(tick: Long) {
        for (sensor in sensors) if (tick % sensor.every == 0L) sensor.measure()
    }

    override fun moveMotors(tick: Long) = machine.tick(tick, command = commands)

    /** The buggy's own left wheel is on port A, its right one on C; a servo pushes the pen at once. */
    private fun commandOf(port: MotorPort): MotorState = when (port) {
        robot.drive.left -> brick.motor(MotorPort.A)
        robot.drive.right -> brick.motor(MotorPort.C)
        robot.pen?.motor -> brick.motor(MotorPort.B).let { if (it.power > 0) it.copy(power = PEN_POWER) else it }
        else -> MotorState(port, MotorMode.FLOAT, power = 0)
    }

    private fun measuring(part: SensorPart, sensor: MicrobitSensor): Measuring {
        val place = SensorPlace(machine, part)
        return when (sensor) {
            is MicrobitSensor.Line -> {
                val eye = LineSensorModel(scene, place, streams, "line sensor ${sensor.line + 1}", realism)
                Measuring(1) { brick.measureLine(sensor.line, eye.percent()) }
            }

            MicrobitSensor.Sonar -> {
                val beam = SonarBeam(
                    scene,
                    place,
                    streams,
                    "sonar",
                    realism,
                    Clock { brick.state.milliseconds },
                    BEAM,
                )
                sonarBias = beam.bias
                hasSonar = true
                Measuring(SONAR_MILLISECONDS) { brick.measureDistance(centimetres(beam)) }
            }
        }
    }

    private fun own(): List<Measuring> {
        val light = boardSensor(SensorKind.LIGHT)
        val eye = NxtLightSensorModel(scene, number, light, streams, "board light", realism)
        val brightness = Measuring(OWN_MILLISECONDS) { brick.measureLight((DARKEST - eye.raw(false)) * BYTE / DARKEST) }
        if (!brick.model.hasMicrophone) return listOf(brightness)
        val ear = Ear(scene, boardSensor(SensorKind.SOUND), streams, "microphone", realism)
        return listOf(
            brightness,
            Measuring(OWN_MILLISECONDS) { brick.measureSound((DARKEST - ear.raw()) * BYTE / DARKEST) },
        )
    }

    /** Where the board is; it looks ahead. */
    private fun boardSensor(kind: SensorKind) =
        SensorPlace(machine, SensorPart(null, kind, robot.brickAt.at, robot.chassis.height, Facing.Ahead(0.0)))

    private fun centimetres(beam: SonarBeam): Int {
        val nearest = beam.of(0).firstOrNull() ?: return NOTHING
        return minOf(floor(nearest).toInt(), NOTHING)
    }

    /** What measures every so many milliseconds. */
    private class Measuring(val every: Int, val measure: () -> Unit)

    private companion object {
        /** Half the angle of the beam of an HC-SR04, degrees. */
        const val BEAM = 12.5

        /** So that what a program hears, at most every 60 ms, is never old. */
        const val SONAR_MILLISECONDS = 20
        const val OWN_MILLISECONDS = 10

        /** The power in the steps of [robotran.simulation.robot.PenLift] with which a servo is down within 0.2 seconds. */
        const val PEN_POWER = 7
        const val NOTHING = 255
        const val DARKEST = 1023
        const val BYTE = 255
    }
}
