package robotran.programs

import robotran.rcxrom.Brick
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.program.ProgramRun
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.rcxrom.state.RunState

/**
 * A brick that runs [program] and records its ROM calls, without those of the firmware.
 *
 * @param raw what the sensors measure, 0..1023.
 */
internal class CallRecorder(private val program: RcxProgram, raw: List<Int>) {
    private val brick = Brick(listOf(Recorded()))

    val calls = ArrayList<TimedCall>()

    /** The numbers of the classes of exceptions that nobody caught. */
    val exceptions = ArrayList<Int>()

    init {
        raw.forEachIndexed { port, value -> brick.setRawSensorValue(port, value) }
    }

    /** Runs it until it ends, for at most [milliseconds]. A thread that fails does not stop the others. */
    fun run(milliseconds: Long) {
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        while (brick.state.milliseconds < milliseconds) {
            brick.tick()
            val state = brick.state.run
            if (state is RunState.Failed) {
                exceptions += state.failure.exceptionNumber
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
