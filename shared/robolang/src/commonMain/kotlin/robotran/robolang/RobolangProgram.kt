package robotran.robolang

import robotran.rcxrom.program.DebuggableRun
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.robolang.check.CheckedProgram
import robotran.robolang.messages.RunMessages
import robotran.robolang.robot.Calibration
import robotran.robolang.run.RobolangRun
import robotran.robolang.run.lower
import robotran.robolang.syntax.Facing

/**
 * A Robolang program without mistakes, ready to be loaded into a brick; [compileRobolang] makes it. Never changes, so
 * it can be started from several threads.
 */
class RobolangProgram internal constructor(
    override val name: String,
    internal val checked: CheckedProgram,
    internal val calibration: Calibration,
    private val messages: RunMessages,
) : RcxProgram {
    private val code by lazy(LazyThreadSafetyMode.PUBLICATION) { lower(checked, name) }

    /** Where its header says that the light sensor looks; null if it says nothing. */
    val lightSensorFacing: LightSensorFacing?
        get() = when (checked.tree.robot?.lightSensor?.facing) {
            Facing.DOWN -> LightSensorFacing.DOWN
            Facing.FORWARD -> LightSensorFacing.FORWARD
            null -> null
        }

    override fun start(rom: Rom): DebuggableRun = RobolangRun(code, calibration, rom, messages)
}
