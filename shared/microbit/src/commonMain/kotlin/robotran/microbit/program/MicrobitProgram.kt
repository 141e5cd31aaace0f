package robotran.microbit.program

import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun

/** A program for a micro:bit, in any language. */
interface MicrobitProgram : BrickProgram {
    /** Starts a new run at the first statement. The run controls the robot only through [board]. */
    fun start(board: Microbit): ProgramRun
}
