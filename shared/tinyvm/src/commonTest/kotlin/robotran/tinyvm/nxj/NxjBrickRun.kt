package robotran.tinyvm.nxj

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.log.LoggedCall
import robotran.brick.program.ProgramFailure
import robotran.brick.program.StatementWatch
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nxt.NxtBrick
import robotran.nxt.log.NxtLogEntry
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.nxt.storage.NxtFile

/** Runs a program on an NXT whose motors turn freely, at ten degrees a second for each percent of power. */
internal class NxjBrickRun(
    program: NxtProgram,
    private val inputs: List<NxjInput> = emptyList(),
    private val isWatched: Boolean = false,
    files: List<NxtFile> = emptyList(),
) {
    val brick = NxtBrick(listOf(program), files = files, messages = NxtMessages.of(Language.ENGLISH))
    private val degrees = DoubleArray(MotorPort.entries.size)
    private val speeds = DoubleArray(MotorPort.entries.size)

    /** The failure with which the program ended, null if it ended otherwise. */
    var failure: ProgramFailure? = null
        private set

    /** When the program ended; -1 if it has not. */
    var endedAt = -1L
        private set

    val calls: List<LoggedCall> get() = brick.log.entries

    /** The printed lines. */
    val printed: List<String>
        get() = calls.filterIsInstance<NxtLogEntry>().filter { it.call.native == NxtNative.CONSOLE_LINE }
            .map { it.call.text.orEmpty() }

    /** The rows of the display in the last millisecond of the program, without empty ones behind them. */
    var screen: List<String> = emptyList()
        private set

    fun run(longest: Long) {
        brick.press(BrickButton.ENTER)
        brick.release(BrickButton.ENTER)
        if (isWatched) brick.debuggableRun?.watch = StatementWatch { false }
        while (brick.state.milliseconds < longest && endedAt < 0) {
            val time = brick.state.milliseconds
            inputs.filter { it.milliseconds == time }.forEach(::happen)
            brick.kind.motorPorts.forEach(::turn)
            brick.tick()
            val state = brick.state
            val run = state.run
            if (run is RunState.Failed) failure = run.failure
            if (run is RunState.Running) {
                screen = state.display.lines.map { it.trimEnd() }.dropLastWhile { it.isEmpty() }
            } else {
                endedAt = time
            }
        }
    }

    private fun happen(input: NxjInput) = when (input) {
        is NxjInput.Analog -> brick.setAnalog(input.port, input.raw)
        is NxjInput.Button -> if (input.isPressed) brick.press(input.button) else brick.release(input.button)
    }

    private fun turn(port: MotorPort) {
        val motor = brick.motor(port)
        val index = port.ordinal
        val wanted = when (motor.mode) {
            MotorMode.FORWARD -> motor.power * SPEED_OF_PERCENT
            MotorMode.BACKWARD -> -motor.power * SPEED_OF_PERCENT
            else -> 0.0
        }
        val lag = if (motor.mode == MotorMode.FLOAT) ROLLING_LAG else LAG
        speeds[index] += (wanted - speeds[index]) / lag
        degrees[index] += speeds[index] / MILLISECONDS
        brick.setHubDegrees(port, degrees[index].toInt())
    }

    private companion object {
        const val SPEED_OF_PERCENT = 10.0
        const val LAG = 70.0
        const val ROLLING_LAG = 300.0
        const val MILLISECONDS = 1000.0
    }
}
