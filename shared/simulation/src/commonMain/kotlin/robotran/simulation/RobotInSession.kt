package robotran.simulation

import robotran.brick.Brick
import robotran.brick.log.CallLog
import robotran.brick.program.RuntimeWarning
import robotran.language.Language
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.rcxrom.infrared.InfraredAir
import robotran.simulation.config.TraceHash
import robotran.simulation.explain.DeviationCause
import robotran.simulation.explain.Explanation
import robotran.simulation.messages.SimulationMessages
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.PortComparison
import robotran.simulation.state.MissingSensors
import robotran.simulation.state.RobotSnapshot
import robotran.world.World

/** One robot of a session: its brick and its machine. */
internal class RobotInSession(
    private val number: Int,
    private val world: World,
    load: RobotProgramSet,
    simulation: Simulation,
    air: InfraredAir,
    network: BluetoothNetwork,
    private val language: Language,
) {
    private val machine = simulation.machines[number]
    val ports: BrickPorts = BrickInstallation(number, world, load, simulation, air, network, language).ports()
    val brick: Brick = ports.brick
    private var hashedCalls = 0L

    private val comparison = PortComparison(world.robots[number].description, SimulationMessages.of(language))

    private val log: CallLog = brick.log

    /** What the current or last program expects at the ports, but the robot does not have there; null for nothing. */
    val missingSensors: MissingSensors? get() = comparison.among(brick.expectedSensors)

    /** Warnings about the current or last program: first what it lacks, then the brick's. */
    val warnings: List<RuntimeWarning> get() = listOfNotNull(missingSensors?.warning) + brick.warnings

    val snapshot: RobotSnapshot
        get() =
            RobotSnapshot(
                brick.state,
                machine.state,
                machine.bumps,
                warnings,
                log.total.toInt(),
                missingSensors,
                machine.bumpedAt,
            )

    /** How loud it is, in percent of the full volume of a brick. */
    val loudness: Int get() = brick.loudness

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
}
