package robotran.simulation

import robotran.brick.Brick
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLog
import robotran.brick.program.RuntimeWarning
import robotran.language.Language
import robotran.nxt.NxtBrick
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.messages.NxtMessages
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.simulation.config.TraceHash
import robotran.simulation.explain.DeviationCause
import robotran.simulation.explain.Explanation
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.nxt.NxtPorts
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.LightReading
import robotran.simulation.robot.PortComparison
import robotran.simulation.robot.RcxPorts
import robotran.simulation.state.MissingSensors
import robotran.simulation.state.RobotSnapshot
import robotran.world.LightFacing
import robotran.world.SensorPart
import robotran.world.World

/** One robot of a session: its brick and its machine. */
internal class RobotInSession(
    private val number: Int,
    private val world: World,
    load: RobotLoad,
    private val simulation: Simulation,
    air: InfraredAir,
    network: BluetoothNetwork,
    private val language: Language,
) {
    private val machine = simulation.machines[number]
    val ports: BrickPorts = portsOf(load, air, network)
    val brick: Brick = ports.brick
    private var hashedCalls = 0L

    private val comparison = PortComparison(world.robots[number].description, SimulationMessages.of(language))

    private val log: CallLog = brick.log

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

    /** How loud it is, in percent of the full volume of a brick. */
    val loudness: Int
        get() = when (val brick = brick) {
            is NxtBrick -> brick.loudness
            else -> if (brick.isSounding) FULL_VOLUME else 0
        }

    /** The causes of its deviation so far. */
    fun deviationCauses(): List<DeviationCause> = Explanation(
        world.robots[number],
        machine,
        ports.sensorErrors,
        SimulationMessages.of(language),
    ).deviationCauses()

    /** Adds the logged calls since the last call of this function. */
    fun addCallsTo(hash: TraceHash) {
        while (hashedCalls < log.total) log[hashedCalls++]?.let(hash::add)
    }

    private fun portsOf(load: RobotLoad, air: InfraredAir, network: BluetoothNetwork): BrickPorts {
        val place = world.robots[number]
        val robot = place.description
        val facing = place.lightFacing ?: load.lightFacing ?: LightFacing.DOWN
        val streams = NoiseStreams(world.seed, number)
        val lightOf = { part: SensorPart ->
            simulation.lightSensor(number, part).let { LightReading { active -> it.raw(facing, active) } }
        }
        return when (robot.brick) {
            BrickKind.RCX -> RcxPorts(
                robot,
                RcxBrick(load.programs.map { it as? RcxProgram }, air, BrickMessages.of(language), load.firstSlot),
                machine,
                lightOf,
                { simulation.temperature },
                streams,
                world.realism,
            )

            BrickKind.NXT -> NxtPorts(
                robot,
                NxtBrick(
                    load.programs,
                    network,
                    place.name,
                    NxtMessages.of(language),
                    load.firstSlot,
                    load.files,
                ),
                simulation.scene,
                number,
                facing,
                lightOf,
                { simulation.temperature },
                air,
                streams,
                world.realism,
            )
        }
    }

    private companion object {
        const val FULL_VOLUME = 100
    }
}
