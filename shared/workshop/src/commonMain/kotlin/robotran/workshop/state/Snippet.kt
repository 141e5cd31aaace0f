package robotran.workshop.state

import robotran.brick.program.BrickProgram
import robotran.hub.program.HubProgram
import robotran.microbit.program.MicrobitProgram
import robotran.nxt.program.NxtProgram
import robotran.rcxrom.program.RcxProgram

/**
 * A program of a few lines of another one, which are to run at once.
 *
 * @property robot the name of the robot that it is for.
 * @property slot the index of the whole program.
 * @property source the text of the whole program. The same line of both has the same number.
 */
interface Snippet : BrickProgram {
    val robot: String
    val slot: Int
    val source: String
}

/** [program] as a [Snippet]. */
internal fun asSnippet(program: BrickProgram, robot: String, slot: Int, source: String): Snippet = when (program) {
    is RcxProgram -> RcxSnippet(program, robot, slot, source)
    is NxtProgram -> NxtSnippet(program, robot, slot, source)
    is HubProgram -> HubSnippet(program, robot, slot, source)
    is MicrobitProgram -> MicrobitSnippet(program, robot, slot, source)
    else -> error("There is no brick for ${program.name}.")
}

private class RcxSnippet(
    program: RcxProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : Snippet,
    RcxProgram by program

private class NxtSnippet(
    program: NxtProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : Snippet,
    NxtProgram by program

private class HubSnippet(
    program: HubProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : Snippet,
    HubProgram by program

private class MicrobitSnippet(
    program: MicrobitProgram,
    override val robot: String,
    override val slot: Int,
    override val source: String,
) : Snippet,
    MicrobitProgram by program
