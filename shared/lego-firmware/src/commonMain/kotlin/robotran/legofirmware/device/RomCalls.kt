package robotran.legofirmware.device

import robotran.rcxrom.call.RomCall
import robotran.rcxrom.program.Rom

/** Calls the ROM for the instruction that is executed, so that the log shows its line. */
internal class RomCalls(val rom: Rom) {
    private var line = NO_LINE
    private var file: String? = null

    /** Sets the place of the next calls; 0 for the firmware itself. */
    fun at(line: Int, file: String?) {
        this.line = line
        this.file = file
    }

    fun call(address: Int, vararg arguments: Int) = rom.call(RomCall(address, arguments.asList()), line, file)

    /** Runs [work], whose calls are the firmware's own. */
    fun <T> asFirmware(work: () -> T): T {
        val lineBefore = line
        val fileBefore = file
        at(NO_LINE, null)
        return work().also { at(lineBefore, fileBefore) }
    }

    companion object {
        const val NO_LINE = 0

        /** Where the firmware has its own data in the brick's memory: a short for results, and a message. */
        const val RESULT = 0x8000
        const val MESSAGE = 0x8060
    }
}
