package robotran.robolang

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.hub.program.Hub
import robotran.hub.program.HubProgram
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitProgram
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtProgram
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.robolang.check.CheckedProgram
import robotran.robolang.messages.RobolangRunMessages
import robotran.robolang.robot.Durations
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.MicrobitUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.run.HubDevice
import robotran.robolang.run.MicrobitDevice
import robotran.robolang.run.NxtDevice
import robotran.robolang.run.RcxDevice
import robotran.robolang.run.RobolangRun
import robotran.robolang.run.RobotDevice
import robotran.robolang.run.lower
import robotran.robolang.syntax.Facing
import robotran.robolang.syntax.ParsedText

/**
 * A valid Robolang program, made by [compileRobolang], ready to be loaded into the brick of the robot that it was
 * compiled for. Immutable, so several threads can start it.
 */
sealed class RobolangProgram(
    override val name: String,
    internal val checked: CheckedProgram,
    internal val messages: RobolangRunMessages,
) : BrickProgram {
    internal abstract val robot: RobotTarget

    private val code by lazy(LazyThreadSafetyMode.PUBLICATION) { lower(checked, name, robot.kind) }

    /** The direction of the light sensor in its header; null if the header does not name it. */
    val lightSensorFacing: LightSensorFacing?
        get() = when (checked.tree.robot?.lightSensor?.facing) {
            Facing.DOWN -> LightSensorFacing.DOWN
            Facing.FORWARD -> LightSensorFacing.FORWARD
            null -> null
        }

    /** Whether this was made of [text] as it was read by somebody else, and not read again. */
    fun isMadeOf(text: ParsedText): Boolean = text.program.tree === checked.tree

    internal fun run(device: RobotDevice, durations: Durations): DebuggableRun =
        RobolangRun(code, device, durations, messages)

    internal companion object {
        fun of(
            name: String,
            checked: CheckedProgram,
            robot: RobotTarget,
            messages: RobolangRunMessages,
        ): RobolangProgram = when (robot) {
            is RobotTarget.Rcx -> RobolangRcxProgram(name, checked, robot, messages)
            is RobotTarget.Nxt -> RobolangNxtProgram(name, checked, robot, messages)
            is RobotTarget.Hub -> RobolangHubProgram(name, checked, robot, messages)
            is RobotTarget.Microbit -> RobolangMicrobitProgram(name, checked, robot, messages)
        }
    }
}

/** A Robolang program for a robot with an RCX. */
class RobolangRcxProgram internal constructor(
    name: String,
    checked: CheckedProgram,
    override val robot: RobotTarget.Rcx,
    messages: RobolangRunMessages,
) : RobolangProgram(name, checked, messages),
    RcxProgram {
    override val kind: BrickKind get() = robot.kind

    override fun start(rom: Rom): DebuggableRun {
        val durations = Durations(robot)
        return run(RcxDevice(rom, robot, durations), durations)
    }
}

/** A Robolang program for a robot with an NXT. */
class RobolangNxtProgram internal constructor(
    name: String,
    checked: CheckedProgram,
    override val robot: RobotTarget.Nxt,
    messages: RobolangRunMessages,
) : RobolangProgram(name, checked, messages),
    NxtProgram {
    override val kind: BrickKind get() = robot.kind

    override fun start(nxt: Nxt): DebuggableRun = run(NxtDevice(nxt, robot), Durations(robot))
}

/** A Robolang program for a robot with a hub that runs Pybricks. */
class RobolangHubProgram internal constructor(
    name: String,
    checked: CheckedProgram,
    public override val robot: RobotTarget.Hub,
    messages: RobolangRunMessages,
) : RobolangProgram(name, checked, messages),
    HubProgram {
    override val kind: BrickKind get() = robot.kind

    override fun start(hub: Hub): DebuggableRun =
        run(HubDevice(hub, robot, HubUses(checked.tree, robot), messages), Durations(robot))
}

/** A Robolang program for a robot with a micro:bit. */
class RobolangMicrobitProgram internal constructor(
    name: String,
    checked: CheckedProgram,
    public override val robot: RobotTarget.Microbit,
    messages: RobolangRunMessages,
) : RobolangProgram(name, checked, messages),
    MicrobitProgram {
    override val kind: BrickKind get() = robot.kind

    override fun start(board: Microbit): DebuggableRun {
        val durations = Durations(robot)
        return run(MicrobitDevice(board, robot, MicrobitUses(checked.tree, robot), durations, messages), durations)
    }
}
