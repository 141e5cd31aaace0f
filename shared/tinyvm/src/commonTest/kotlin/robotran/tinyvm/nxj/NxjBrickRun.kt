package robotran.tinyvm.nxj

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.log.LoggedCall
import robotran.brick.program.ProgramFailure
import robotran.brick.state.RunState
import robotran.nxt.NxtBrick
import robotran.tinyvm.NxjProgram

/** A press of a button for some time. */
internal class Press(val button: BrickButton, val from: Long, val until: Long)

/** Runs a program on an NXT whose motors turn freely, at ten degrees a second for each percent of power. */
internal class NxjBrickRun(program: NxjProgram, private val presses: List<Press>, private val analog: List<Analog>) {
    val brick = NxtBrick(listOf(program))
    private val degrees = DoubleArray(MotorPort.entries.size)
    private val speeds = DoubleArray(MotorPort.entries.size)
    private val screens = ArrayList<List<String>>()

    /** What the analog pin of a port, 0..3, measures from a time on. */
    class Analog(val port: Int, val from: Long, val raw: Int)

    /** The first failure. */
    var failure: ProgramFailure? = null
        private set

    /** When the program ended; -1 if it has not. */
    var endedAt = -1L
        private set

    val calls: List<LoggedCall> get() = brick.log.entries

    /** The rows of the screen in the last millisecond of the program, without empty ones at the end. */
    val screen: List<String> get() = screens.last()

    fun run(longest: Long) {
        screens += emptyList<String>()
        brick.press(BrickButton.ENTER)
        brick.release(BrickButton.ENTER)
        while (brick.state.milliseconds < longest && endedAt < 0) {
            val time = brick.state.milliseconds
            presses.filter { it.from == time }.forEach { brick.press(it.button) }
            presses.filter { it.until == time }.forEach { brick.release(it.button) }
            analog.filter { it.from == time }.forEach { brick.setAnalog(it.port, it.raw) }
            MotorPort.entries.forEach(::turn)
            brick.tick()
            val state = brick.state.run
            if (state is RunState.Failed && failure == null) failure = state.failure
            val isOver = state !is RunState.Running && state !is RunState.Failed
            if (isOver || brick.debuggableRun == null) {
                endedAt = time
            } else if (brick.state.exception == null) {
                screens[0] = brick.state.display.lines.map { it.trimEnd() }.dropLastWhile { it.isEmpty() }
            }
        }
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
