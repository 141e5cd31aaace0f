package robotran.simulation

import robotran.brick.kind.BrickKind
import robotran.hub.HubBrick
import robotran.hub.messages.HubMessages
import robotran.hub.model.HubModel
import robotran.language.Language
import robotran.microbit.MicrobitBrick
import robotran.microbit.messages.MicrobitMessages
import robotran.microbit.model.MicrobitModel
import robotran.nxt.NxtBrick
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.messages.NxtMessages
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.simulation.hub.HubPorts
import robotran.simulation.microbit.MicrobitPorts
import robotran.simulation.microbit.buggyWiring
import robotran.simulation.noise.NoiseStreams
import robotran.simulation.nxt.NxtPorts
import robotran.simulation.robot.BrickPorts
import robotran.simulation.robot.LightReading
import robotran.simulation.robot.RcxPorts
import robotran.world.LightFacing
import robotran.world.SensorPart
import robotran.world.World

/** Puts a brick of each kind into the robot number [number] of a session. */
internal class BrickInstallation(
    private val number: Int,
    private val world: World,
    private val load: RobotProgramSet,
    private val simulation: Simulation,
    private val air: InfraredAir,
    private val network: BluetoothNetwork,
    private val language: Language,
) {
    private val placement = world.robots[number]
    private val robot = placement.description
    private val facing = placement.lightFacing ?: load.lightFacing ?: LightFacing.DOWN
    private val streams = NoiseStreams(world.seed, number)
    private val lightOf = { part: SensorPart ->
        simulation.lightSensor(number, part).let { LightReading { active -> it.raw(facing, active) } }
    }

    /** A new brick, connected with its machine. */
    fun ports(): BrickPorts = when (robot.brick) {
        BrickKind.RCX -> RcxPorts(
            robot,
            RcxBrick(load.programs.map { it as? RcxProgram }, air, BrickMessages.of(language), load.firstSlot),
            simulation.machines[number],
            lightOf,
            { simulation.temperature },
            streams,
            world.realism,
        )

        BrickKind.NXT -> NxtPorts(
            robot,
            NxtBrick(load.programs, network, placement.name, NxtMessages.of(language), load.firstSlot, load.files),
            simulation.scene,
            number,
            facing,
            lightOf,
            { simulation.temperature },
            air,
            streams,
            world.realism,
        )

        BrickKind.SPIKE_PRIME, BrickKind.SPIKE_ESSENTIAL, BrickKind.TECHNIC_HUB, BrickKind.EV3, BrickKind.NXT_PYBRICKS,
        -> HubPorts(
            robot,
            HubBrick(checkNotNull(HubModel.of(robot.brick)), load.programs, HubMessages.of(language), load.firstSlot),
            simulation.scene,
            number,
            facing,
            streams,
            world.realism,
        )

        BrickKind.MICROBIT, BrickKind.MICROBIT_V1 -> MicrobitPorts(
            robot,
            MicrobitBrick(
                checkNotNull(MicrobitModel.of(robot.brick)),
                checkNotNull(robot.buggyWiring),
                robot.pen != null,
                load.programs,
                MicrobitMessages.of(language),
                load.firstSlot,
            ),
            simulation.scene,
            number,
            streams,
            world.realism,
        )
    }
}
