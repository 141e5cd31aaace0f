package robotran.hub.shell

import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.hub.display.HubScreen
import robotran.hub.hardware.HubHardware
import robotran.hub.messages.HubMessages
import robotran.hub.model.HubButton
import robotran.hub.program.Hub
import robotran.hub.program.HubProgram

/** Handles the buttons, starts and ends programs, and shows what has gone wrong. */
internal class HubShell(
    private val programs: List<BrickProgram?>,
    private val hardware: HubHardware,
    private val hub: Hub,
    private val messages: HubMessages,
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
    var leftByProgram: HubScreen? = null
        private set

    /** Why the robot stopped; null if that needs no explanation. */
    var explanation: String? = null
        private set

    /** Index of the program that the button in the middle starts. */
    var selectedSlot = firstSlot
        private set

    val runState: RunState get() = run?.let { RunState.Running(it.sourceLine, it.sourceFile) } ?: ending
    val warnings: List<RuntimeWarning> get() = run?.warnings ?: previousWarnings
    val debuggableRun: DebuggableRun? get() = run as? DebuggableRun
    val isPaused: Boolean get() = pausedSteps > 0

    init {
        showMenu()
    }

    fun pressed(button: HubButton) {
        if (run != null) {
            if (button == hardware.buttons.stopButton) end(RunState.Ended(stopped = true))
            return
        }
        when (button) {
            HubButton.CENTER -> programOf(selectedSlot)?.let { start(it, isSnippet = false) }
            HubButton.LEFT, HubButton.UP -> select(-1)
            HubButton.RIGHT, HubButton.DOWN -> select(1)
            else -> Unit
        }
    }

    /** Ends the program, and clears what is said about a failure. */
    fun stopProgram() {
        if (run != null) {
            end(RunState.Ended(stopped = true))
        } else if (ending is RunState.Failed) {
            explanation = null
            showMenu()
        }
    }

    fun runSnippet(program: HubProgram) {
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

    private fun programOf(slot: Int): HubProgram? =
        (programs.getOrNull(slot) as? HubProgram)?.takeIf { it.kind == hardware.model.kind }

    private fun start(program: HubProgram, isSnippet: Boolean) {
        this.isSnippet = isSnippet
        explanation = null
        leftByProgram = null
        hardware.reset()
        hardware.display.clear()
        hardware.buttons.startRun()
        hardware.inputs.startRun()
        waitUntil = hardware.milliseconds
        run = program.start(hub)
    }

    private fun end(how: RunState.Ended) {
        explanation = if (hardware.isDriving && !how.stopped) messages.motorsRollAtEnd() else null
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
        hardware.reset()
        showMenu()
    }

    private fun select(step: Int) {
        selectedSlot = (selectedSlot + step).coerceIn(0, maxOf(0, programs.size - 1))
        showMenu()
    }

    /** The number of the slot on the lights, the names of the programs on a screen. What was printed stays. */
    private fun showMenu() {
        if (hardware.model.hasMatrix) hardware.display.showCharacter("${selectedSlot + 1}")
        if (!hardware.model.hasScreen) return
        val rows = programs.mapIndexed { slot, program ->
            (if (slot == selectedSlot) "> " else "  ") + (program?.name ?: "-")
        }
        hardware.display.showRows(rows)
    }
}
