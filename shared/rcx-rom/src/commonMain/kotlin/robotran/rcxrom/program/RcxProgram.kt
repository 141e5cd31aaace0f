package robotran.rcxrom.program

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun

/** A program for an RCX. */
interface RcxProgram : BrickProgram {
    override val kind: BrickKind get() = BrickKind.RCX

    /** The firmware that it runs on; null for leJOS's. */
    val firmware: RcxFirmware? get() = null

    /** Starts a new run at the first statement. The run controls the robot only through [rom]. */
    fun start(rom: Rom): ProgramRun
}
