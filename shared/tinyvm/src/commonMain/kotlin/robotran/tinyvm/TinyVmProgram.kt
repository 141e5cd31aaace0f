package robotran.tinyvm

import robotran.brick.program.DebuggableRun
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.TinyVmRunMessages

/**
 * A linked leJOS program, ready to load into a brick; created by [linkTinyVm]. Immutable, so it can be started from
 * several threads.
 */
class TinyVmProgram internal constructor(
    override val name: String,
    internal val linked: LinkedProgram,
    private val mode: TinyVmMode,
    private val messages: TinyVmRunMessages,
    private val speed: TinyVmSpeed,
    private val version: LejosVersion,
) : RcxProgram {
    override fun start(rom: Rom): DebuggableRun = TinyVmRun(linked, rom, mode, messages, speed, version)
}
