package robotran.microbit.shell

import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.microbit.display.BoardScreen
import robotran.microbit.hardware.BoardHardware
import robotran.microbit.messages.MicrobitMessages
import robotran.microbit.model.MicrobitButton
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative
import robotran.microbit.program.MicrobitProgram

/**
 * Starts and ends programs, and does what the frame of a program in Python does around them: makes the buggy ready, stops its
 * wheels, waits for button A with an arrow on the lights, and stops wheels and sound at the end.
 *
 * @param hasPen whether a servo moves a pen.
 */
internal class MicrobitShell(
    private val programs: List<BrickProgram?>,
    private val hardware: BoardHardware,
    private val hasPen: Boolean,
    private val board: Microbit,
    private val messages: MicrobitMessages,
    firstSlot: Int,
) {
    private var run: ProgramRun? = null
    private var waitUntil = 0L
    private var pausedSteps = 0
    private var ending: RunState = RunState.Idle
    private var previousWarnings: List<RuntimeWarning> = emptyList()

    /** Whether the current or last run is of a program that [runSnippet] got. */
    var isSnippet = false
        private set

    /** What the last program had shown when it ended; null while one runs. */
    var leftByProgram: BoardScreen? = null
        private set

    /** Why the robot stopped; null if that needs no explanation. */
    var explanation: String? = null
        private set

    /** Index of the program that button A starts. */
    var selectedSlot = firstSlot
        private set

    val runState: RunState get() = run?.let { RunState.Running(it.sourceLine, it.sourceFile) } ?: ending
    val warnings: List<RuntimeWarning> get() = run?.warnings ?: previousWarnings
    val debuggableRun: DebuggableRun? get() = run as? DebuggableRun
    val isPaused: Boolean get() = pausedSteps > 0

    init {
        showReady()
    }

    /** Of several programs, button B chooses the next one. */
    fun pressed(button: MicrobitButton) {
        if (run != null) return
        when (button) {
            MicrobitButton.A -> programOf(selectedSlot)?.let { start(it, isSnippet = false) }

            MicrobitButton.B -> if (programs.size > 1) {
                selectedSlot = (selectedSlot + 1) % programs.size
                showReady()
            }

            MicrobitButton.LOGO -> Unit
        }
    }

    /** Ends the program, and clears what is said about a failure. */
    fun stopProgram() {
        if (run != null) {
            end(RunState.Ended(stopped = true))
        } else if (ending is RunState.Failed) {
            explanation = null
            showReady()
        }
    }

    fun runSnippet(program: MicrobitProgram) {
        stopProgram()
        start(program, isSnippet = true)
    }

    /** Runs the program for [steps], its share of a millisecond, or for the rest of it after a pause. */
    fun resumeProgram(steps: Int) {
        val run = run ?: return
        if (hardware.milliseconds < waitUntil) return
        val share = if (isPaused) pausedSteps else steps
        pausedSteps = 0
        when (val status = run.resume(share)) {
            ProgramStatus.Running -> Unit
            is ProgramStatus.Paused -> pausedSteps = status.stepsLeft
            is ProgramStatus.Waiting -> waitUntil = status.untilMilliseconds
            is ProgramStatus.ThreadFailed -> fail(status.failure)
            ProgramStatus.Ended -> end(RunState.Ended(stopped = false))
            is ProgramStatus.Failed -> fail(status.failure)
        }
    }

    private fun programOf(slot: Int): MicrobitProgram? =
        (programs.getOrNull(slot) as? MicrobitProgram)?.takeIf { it.kind == hardware.model.kind }

    private fun start(program: MicrobitProgram, isSnippet: Boolean) {
        this.isSnippet = isSnippet
        explanation = null
        leftByProgram = null
        hardware.display.reset()
        hardware.buttons.startRun()
        for (call in hardware.buggy.startCalls(hasPen)) hardware.perform(call)
        waitUntil = hardware.milliseconds
        run = program.start(board)
    }

    private fun end(how: RunState.Ended) {
        explanation = if (hardware.isDriving && !how.stopped) messages.wheelsStopAtEnd() else null
        leave(how)
    }

    private fun fail(failure: ProgramFailure) {
        hardware.display.print(failure.message)
        explanation = messages.failureShown(failure)
        leave(RunState.Failed(failure))
    }

    private fun leave(how: RunState) {
        previousWarnings = warnings
        ending = how
        run = null
        pausedSteps = 0
        leftByProgram = hardware.display.screen
        for (call in hardware.buggy.stopCalls) hardware.perform(call)
        hardware.perform(MicrobitCall.of(MicrobitNative.MUSIC_STOP))
        showReady()
    }

    /** An arrow to button A, or the number of the program if there are several. What was printed stays. */
    private fun showReady() {
        if (programs.size > 1) hardware.display.show("${selectedSlot + 1}") else hardware.display.draw(ARROW)
    }

    private companion object {
        const val ON = '#'
        val ARROW = "..#...#...#####.#.....#..".map { it == ON }
    }
}
