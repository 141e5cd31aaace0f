package robotran.programs

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramRun
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom

/**
 * A brick that runs [program] and records its ROM calls, without those of the firmware.
 *
 * @param happen called before each millisecond with its number, to press buttons and to set what sensors measure.
 */
internal class CallRecorder(private val program: RcxProgram, private val happen: (RcxBrick, Long) -> Unit) {
    private val brick = RcxBrick(listOf(Recorded()), messages = BrickMessages.of(Language.ENGLISH))

    val calls = ArrayList<TimedCall>()

    /** The numbers of the methods and classes of exceptions that nobody caught. */
    val failures = ArrayList<Pair<Int, Int>>()

    /** Whether the program has ended. */
    val isOver: Boolean get() = brick.state.run !is RunState.Running

    /** Runs it until it ends, for at most [milliseconds]. A thread that fails does not stop the others. */
    fun run(milliseconds: Long) {
        happen(brick, 0)
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        while (brick.state.milliseconds < milliseconds) {
            happen(brick, brick.state.milliseconds + 1)
            brick.tick()
            val state = brick.state.run
            if (state is RunState.Failed) {
                failures += state.failure.methodNumber to state.failure.exceptionNumber
                if (brick.debuggableRun == null) return
                brick.press(BrickButton.ON_OFF)
                brick.release(BrickButton.ON_OFF)
            } else if (state !is RunState.Running) {
                return
            }
        }
    }

    private inner class Recorded : RcxProgram {
        override val name: String get() = program.name

        override fun start(rom: Rom): ProgramRun = program.start(RecordedRom(rom))
    }

    private inner class RecordedRom(private val rom: Rom) : Rom by rom {
        override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
            rom.call(call, sourceLine, sourceFile)
            calls += TimedCall(rom.milliseconds, call.withoutAddresses())
        }
    }
}
