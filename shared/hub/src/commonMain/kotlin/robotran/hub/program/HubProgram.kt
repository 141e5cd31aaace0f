package robotran.hub.program

import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun

/** A program for a hub, in any language. */
interface HubProgram : BrickProgram {
    /** Starts a new run at the first statement. The run controls the robot only through [hub]. */
    fun start(hub: Hub): ProgramRun
}
