package robotran.robolang

import robotran.robolang.check.CheckedProgram
import robotran.robolang.run.RobolangRun
import robotran.rom.ProgramRun
import robotran.rom.RcxProgram
import robotran.rom.Rom

/** A Robolang program without mistakes, ready to be loaded into a brick; [readRobolang] makes it. Never changes. */
class RobolangProgram internal constructor(
    override val name: String,
    internal val checked: CheckedProgram,
    private val calibration: Calibration,
) : RcxProgram {
    override fun start(rom: Rom): ProgramRun = RobolangRun(checked.tree, calibration, rom)
}
