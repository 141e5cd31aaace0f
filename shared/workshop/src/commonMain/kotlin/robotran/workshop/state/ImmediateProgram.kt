package robotran.workshop.state

import robotran.brick.program.BrickProgram
import robotran.nxt.program.NxtProgram
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

/** [program] as an [ImmediateProgram]. */
internal fun immediate(program: BrickProgram, robot: String, slot: Int, source: String): ImmediateProgram =
    when (program) {
        is RcxProgram -> ImmediateRcxProgram(program, robot, slot, source)
        is NxtProgram -> ImmediateNxtProgram(program, robot, slot, source)
        else -> error("There is no brick for ${program.name}.")
    }

private class ImmediateRcxProgram(
    program: RcxProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : ImmediateProgram,
    RcxProgram by program

private class ImmediateNxtProgram(
    program: NxtProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : ImmediateProgram,
    NxtProgram by program
