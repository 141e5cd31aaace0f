package robotran.nxt.program

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun

/** A program for an NXT, in any language. */
interface NxtProgram : BrickProgram {
    override val kind: BrickKind get() = BrickKind.NXT

    /** Starts a new run at the first statement. The run controls the robot only through [nxt]. */
    fun start(nxt: Nxt): ProgramRun
}
