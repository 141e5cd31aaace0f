package robotran.tinyvm.programs

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom

/** The display [glass] after a refresh on [line]; [isNumber] is true if a number was set before it. */
internal class Shown(val line: Int, val glass: LcdGlass, val isNumber: Boolean)

/** A brick that runs [program] and records its output. */
internal class RecordingBrick(program: RcxProgram, private val events: List<Event>) {
    private val brick = RcxBrick(listOf(Watched(program)), messages = BrickMessages.of(Language.ENGLISH))
    private var isNumber = false

    val shown = ArrayList<Shown>()
    val failures = ArrayList<ProgramFailure>()

    /** The ROM calls of each program line, with their words. */
    val romCalls: Map<Int, List<String>>
        get() = brick.log.entries.filter {
            it.sourceLine > 0
        }.groupBy({ it.sourceLine }, { it.text.substringBefore(" ; ").substringAfter(' ') })

    /** The ROM log without times. */
    val log: List<String> get() = brick.log.entries.map { it.text.substringAfter(' ') }

    val milliseconds: Long get() = brick.state.milliseconds
    val isRunning: Boolean get() = brick.state.run is RunState.Running
    val warnings: List<String> get() = brick.warnings.map { "${it.sourceLine}: ${it.message}" }

    /** Starts the program and runs it until it ends, for at most [milliseconds]. */
    fun run(milliseconds: Long) {
        happen(0)
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        while (this.milliseconds < milliseconds) {
            happen(this.milliseconds + 1)
            brick.tick()
            val state = brick.state.run
            if (state is RunState.Failed) {
                failures += state.failure
                if (brick.debuggableRun == null) return
                brick.press(BrickButton.ON_OFF)
                brick.release(BrickButton.ON_OFF)
            } else if (state !is RunState.Running) {
                return
            }
        }
    }

    private fun happen(time: Long) = events.filter { it.milliseconds == time }.forEach { event ->
        when (event) {
            is Event.Sensor -> brick.setRawSensorValue(event.port, event.raw)
            is Event.Button -> if (event.isPressed) brick.press(event.button) else brick.release(event.button)
        }
    }

    private inner class Watched(private val program: RcxProgram) : RcxProgram {
        override val name: String get() = program.name

        override fun start(rom: Rom): ProgramRun = program.start(WatchedRom(rom))
    }

    private inner class WatchedRom(private val rom: Rom) : Rom by rom {
        override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
            rom.call(call, sourceLine, sourceFile)
            if (call.address == RomAddress.SET_LCD_NUMBER && call.arguments.firstOrNull() != RomCode.LCD_PROGRAM) {
                isNumber = true
            }
            if (call.address != RomAddress.REFRESH_LCD) return
            shown += Shown(sourceLine, brick.state.glass, isNumber)
            isNumber = false
        }
    }
}
