package robotran.rcxrom

import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom

/** A program of actions, one per step; after the last one it returns [statusAtEnd]. */
internal class ScriptedProgram(
    private val actions: List<(Rom) -> ProgramStatus>,
    private val statusAtEnd: ProgramStatus = ProgramStatus.Ended,
    override val name: String = "script",
) : RcxProgram {
    /** Number of runs started. */
    var starts = 0
        private set

    override fun start(rom: Rom): ProgramRun {
        starts++
        return Run(rom)
    }

    private inner class Run(private val rom: Rom) : ProgramRun {
        private var done = 0
        override val sourceLine: Int get() = minOf(done + 1, actions.size)

        override fun resume(steps: Int): ProgramStatus {
            repeat(steps) {
                if (done == actions.size) return statusAtEnd
                val status = actions[done](rom)
                done++
                if (status != ProgramStatus.Running) return status
            }
            return ProgramStatus.Running
        }
    }
}

/** An action that calls a routine. */
internal fun calling(address: Int, vararg arguments: Int): (Rom) -> ProgramStatus = { rom ->
    rom.call(RomCall(address, arguments.toList()), TEST_LINE)
    ProgramStatus.Running
}

/** An action that waits. */
internal fun waiting(milliseconds: Int): (Rom) -> ProgramStatus = { rom ->
    ProgramStatus.Waiting(rom.milliseconds + milliseconds)
}

/** A program that never ends and does nothing. */
internal fun endlessProgram() = ScriptedProgram(emptyList(), statusAtEnd = ProgramStatus.Running)
