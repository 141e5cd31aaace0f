package robotran.simulation

import robotran.brick.Brick
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLog
import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.simulation.config.TraceHash
import robotran.simulation.explain.DeviationCause
import robotran.simulation.explain.Explanation
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.LightReading
import robotran.simulation.robot.PortComparison
import robotran.simulation.robot.RcxPorts
import robotran.simulation.state.MissingSensors
import robotran.simulation.state.RobotSnapshot
import robotran.world.LightFacing
import robotran.world.World

/** One robot of a session: its brick and its machine. */
internal class RobotInSession(
    private val number: Int,
    private val world: World,
    load: RobotLoad,
    private val simulation: Simulation,
    air: InfraredAir,
    private val language: Language,
) {
    private val machine = simulation.machines[number]
    val ports: BrickPorts = portsOf(load, air)
    val brick: Brick get() = ports.brick
    private var hashedCalls = 0L

    private val comparison = PortComparison(world.robots[number].description, SimulationMessages.of(language))

    private val log: CallLog get() = brick.log

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
                log.total.toInt(),
                missingSensors,
                machine.bumpedAt,
            )

    /** The causes of its deviation so far. */
    fun deviationCauses(): List<DeviationCause> {
        val hasLightSensor = world.robots[number].description.parts.any {
            it.port != null && it.kind == SensorKind.LIGHT
        }
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

    /** Adds the logged calls since the last call of this function. */
    fun addCallsTo(hash: TraceHash) {
        while (hashedCalls < log.total) log[hashedCalls++]?.let(hash::add)
    }

    private fun portsOf(load: RobotLoad, air: InfraredAir): BrickPorts {
        val robot = world.robots[number].description
        val facing = world.robots[number].lightFacing ?: load.lightFacing ?: LightFacing.DOWN
        // There is no other brick yet: a robot that needs one stands still.
        val programs = if (robot.brick == BrickKind.RCX) load.programs.map { it as? RcxProgram } else emptyList()
        return RcxPorts(
            robot,
            RcxBrick(programs, air, BrickMessages.of(language), load.firstSlot),
            machine,
            { part -> simulation.lightSensor(number, part).let { LightReading { active -> it.raw(facing, active) } } },
            { simulation.temperature },
            NoiseStreams(world.seed, number),
            world.realism,
        )
    }
}
