package robotran.simulation

import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom

/** Sends a message, if there is one, and waits forever for one. */
class MessageProgram(private val sends: List<Int>) : RcxProgram {
    override val name = "message"

    /** Whether any message has arrived. */
    var hasHeard = false
        private set

    override fun start(rom: Rom): ProgramRun = object : ProgramRun {
        override val sourceLine = 1

        init {
            rom.call(RomCall(0x30d0, listOf(0, 0, 1, 1)), sourceLine)
            sends.forEachIndexed { place, byte -> rom.memory.writeByte(BUFFER + place, byte) }
            if (sends.isNotEmpty()) rom.call(RomCall(0x343e, listOf(0x1775, 0, BUFFER, sends.size)), sourceLine)
        }

        override fun resume(steps: Int): ProgramStatus {
            if (rom.hasMessage) hasHeard = true
            return ProgramStatus.Waiting(rom.milliseconds + 1)
        }
    }

    private companion object {
        /** An address in the memory for programs. */
        const val BUFFER = 0x9000
    }
}
