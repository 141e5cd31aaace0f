package robotran.workshop.state

import robotran.rcxrom.program.RcxProgram

/**
 * A program of a few lines of another one, which are to run at once.
 *
 * @property robot the name of the robot that it is for.
 * @property slot the index of the whole program.
 * @property source the text of the whole program. The same line of both has the same number.
 */
class ImmediateProgram internal constructor(
    private val program: RcxProgram,
    val robot: String,
    val slot: Int,
    val source: String,
) : RcxProgram by program
