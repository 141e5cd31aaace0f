package robotran.robolang

import robotran.brick.program.DebuggableRun
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.robolang.check.CheckedProgram
import robotran.robolang.messages.RunMessages
import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget
import robotran.robolang.run.RobolangRun
import robotran.robolang.run.device.RcxDevice
import robotran.robolang.run.lower
import robotran.robolang.syntax.Facing

/**
 * A valid Robolang program, made by [compileRobolang], ready to be loaded into a brick. Immutable, so several threads
 * can start it.
 */
class RobolangProgram internal constructor(
    override val name: String,
    internal val checked: CheckedProgram,
    internal val robot: RobotTarget,
    private val messages: RunMessages,
) : RcxProgram {
    private val code by lazy(LazyThreadSafetyMode.PUBLICATION) { lower(checked, name, robot.kind) }

    /** The direction of the light sensor in its header; null if the header does not name it. */
    val lightSensorFacing: LightSensorFacing?
        get() = when (checked.tree.robot?.lightSensor?.facing) {
            Facing.DOWN -> LightSensorFacing.DOWN
            Facing.FORWARD -> LightSensorFacing.FORWARD
            null -> null
        }

    override fun start(rom: Rom): DebuggableRun {
        val durations = Durations(robot)
        return RobolangRun(code, RcxDevice(rom, durations), durations, messages)
    }
}
