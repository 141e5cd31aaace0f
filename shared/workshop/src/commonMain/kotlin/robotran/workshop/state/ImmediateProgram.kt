package robotran.workshop.state

import robotran.brick.program.BrickProgram
import robotran.rcxrom.program.RcxProgram

/**
 * A program of a few lines of another one, which are to run at once.
 *
 * @property robot the name of the robot that it is for.
 * @property slot the index of the whole program.
 * @property source the text of the whole program. The same line of both has the same number.
 */
interface ImmediateProgram : BrickProgram {
    val robot: String
    val slot: Int
    val source: String
}

/** An [ImmediateProgram] for an RCX. */
internal class ImmediateRcxProgram(
    program: RcxProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : ImmediateProgram,
    RcxProgram by program
