package robotran.simulation

import robotran.brick.controls.MotorPort
import robotran.brick.log.CallLog
import robotran.brick.program.RuntimeWarning
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.simulation.config.TraceHash
import robotran.simulation.explain.DeviationCause
import robotran.simulation.explain.Explanation
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.robot.InputPorts
import robotran.simulation.robot.LightReading
import robotran.simulation.robot.PortComparison
import robotran.simulation.state.MissingSensors
import robotran.simulation.state.RobotSnapshot
import robotran.world.LightFacing
import robotran.world.PortSensor
import robotran.world.World
import kotlin.math.floor

/** One robot of a session: its brick and its machine. */
internal class RobotInSession(
    private val number: Int,
    private val world: World,
    load: RobotLoad,
    private val simulation: Simulation,
    air: InfraredAir,
    private val language: Language,
) {
    val brick = RcxBrick(load.programs, air, BrickMessages.of(language), load.firstSlot)
    val machine = simulation.machines[number]
    val ports = InputPorts(world.robots[number], brick, NoiseStreams(world.seed, number), world.realism)
    private val facing = world.robots[number].lightFacing ?: load.lightFacing ?: LightFacing.DOWN
    private val light = LightReading { active -> simulation.lightOn(number, facing, active) }
    private var millivolts = 0
    private var hashedCalls = 0L

    private val comparison = PortComparison(world.robots[number], SimulationMessages.of(language))

    val romLog: CallLog get() = brick.log

    /** What the current or last program expects at the ports, but the robot does not have there; null for nothing. */
    val missingSensors: MissingSensors? get() = comparison.among(brick.expectedSensors)

    /** Warnings about the current or last program: first what it lacks, then the brick's. */
    val remarks: List<RuntimeWarning> get() = listOfNotNull(missingSensors?.remark) + brick.remarks

    val snapshot: RobotSnapshot
        get() =
            RobotSnapshot(
                brick.state,
                machine.state,
                machine.bumps,
                remarks,
                romLog.total.toInt(),
                missingSensors,
                machine.bumpedAt,
            )

    /** The causes of its deviation so far. */
    fun deviationCauses(): List<DeviationCause> {
        val hasLightSensor = world.robots[number].ports.any { PortSensor.LIGHT in it }
        val realism = if (hasLightSensor) world.realism else 0.0
        val bias = if (hasLightSensor) ports.lightBias else 0.0
        return Explanation(
            world.robots[number],
            machine,
            bias,
            realism,
            SimulationMessages.of(language),
        ).deviationCauses()
    }

    /** Measures the input ports; call it just before the firmware reads them. */
    fun sense() {
        ports.measure(machine, simulation.temperature, light)
        val now = floor(machine.battery.volts * MILLIVOLTS_PER_VOLT).toInt()
        if (world.realism > 0 && kotlin.math.abs(now - millivolts) >= MILLIVOLT_TOLERANCE) {
            millivolts = now
            brick.setBattery(now)
        }
    }

    /** Advances the motors by the millisecond number [tick]. */
    fun moveMotors(tick: Long) =
        machine.tick(brick.motor(MotorPort.A), brick.motor(MotorPort.B), brick.motor(MotorPort.C), tick)

    /** Adds the ROM calls since the last call of this function. */
    fun addCallsTo(hash: TraceHash) {
        while (hashedCalls < romLog.total) romLog[hashedCalls++]?.let(hash::add)
    }

    private companion object {
        const val MILLIVOLTS_PER_VOLT = 1000

        /** Half of the resolution of the brick's converter. */
        const val MILLIVOLT_TOLERANCE = 14
    }
}
