package robotran.robolang

import robotran.robolang.run.RobolangRun
import robotran.robolang.syntax.SyntaxTree
import robotran.rom.ProgramRun
import robotran.rom.RcxProgram
import robotran.rom.Rom

/** A Robolang program without mistakes, ready to be loaded into a brick; [readRobolang] makes it. Never changes. */
class RobolangProgram internal constructor(
    override val name: String,
    internal val tree: SyntaxTree,
    private val calibration: Calibration,
) : RcxProgram {
    override fun start(rom: Rom): ProgramRun = RobolangRun(tree, calibration, rom)
}
