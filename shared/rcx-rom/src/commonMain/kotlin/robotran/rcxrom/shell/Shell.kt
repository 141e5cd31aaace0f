package robotran.rcxrom.shell

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.RcxShell
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sound.SystemSounds

/**
 * The leJOS shell: handles the buttons, starts and ends program runs, and answers messages between runs. Source: leJOS
 * `main.c`.
 */
internal class Shell(
    private val programs: List<RcxProgram?>,
    private val hardware: Hardware,
    private val messages: BrickMessages,
    firstSlot: Int,
) : RcxShell {
    private val rom = hardware.rom
    private val buttons = hardware.buttons
    private val firmware = Firmware(rom, hardware.speaker)
    private val mailbox = ShellMailbox(hardware.memory, firmware, messages, hardware.log)
    private var run: ProgramRun? = null
    private var waitUntil = 0L
    private var pausedSteps = 0
    private val ending = ProgramExit(messages)
    private var previousWarnings: List<RuntimeWarning> = emptyList()
    private val pressedInShell = mutableSetOf<BrickButton>()
    private var runWasHeldWithOnOff = false
    private var powerOffTime = 0L
    private var isSwitchingOff = false

    override var isSnippet = false
        private set

    override var poweredOn = false
        private set

    override var selectedSlot = firstSlot
        private set

    override val runState: RunState
        get() {
            val run = run ?: return ending.state
            return ending.shownFailure?.let { RunState.Failed(it) } ?: RunState.Running(run.sourceLine, run.sourceFile)
        }

    override val warnings: List<RuntimeWarning> get() = run?.warnings ?: previousWarnings

    /** See [ProgramExit.explanation]. */
    override val explanation: String? get() = ending.explanation

    /** Starts for the first time, after the batteries were inserted and the firmware loaded. */
    override fun begin() {
        if (!hardware.timerRuns) firmware.initialize()
        poweredOn = true
        showReady(SystemSounds.TWO_BEEPS)
    }

    override fun pressed(button: BrickButton) {
        if (button == BrickButton.ON_OFF) {
            runWasHeldWithOnOff = false
            hardware.wake()
        }
        if (BrickButton.ON_OFF in buttons.pressed && BrickButton.RUN in buttons.pressed) runWasHeldWithOnOff = true
        if (!isReady) return
        pressedInShell += button
        if (button == BrickButton.PRGM && programs.isNotEmpty()) firmware.play(SystemSounds.BEEP)
    }

    override fun released(button: BrickButton) {
        val wasPressedInShell = pressedInShell.remove(button)
        when {
            button == BrickButton.ON_OFF -> onOffReleased()
            !isReady || !wasPressedInShell -> return
            button == BrickButton.PRGM -> selectNextSlot()
            button == BrickButton.RUN -> startProgram()
        }
    }

    override fun stopProgram() {
        hardware.wake()
        if (run != null) {
            endProgram()
        } else if (ending.shownFailure != null) {
            leaveFailure()
        }
    }

    /** See [robotran.rcxrom.RcxBrick.runSnippet]. */
    override fun runSnippet(program: RcxProgram) {
        hardware.wake()
        when {
            run != null -> endProgram()
            !poweredOn -> powerUp()
            ending.shownFailure != null -> leaveFailure()
        }
        pressedInShell.clear()
        start(program, isSnippet = true)
    }

    override val debuggableRun: DebuggableRun? get() = run as? DebuggableRun

    override val isPaused: Boolean get() = pausedSteps > 0

    /**
     * Advances the shell by one millisecond: answers messages, and switches the brick off when it was idle for long.
     */
    override fun tick() {
        when {
            isSwitchingOff -> if (hardware.isSilent) finishSwitchingOff()
            !isReady -> return
            mailbox.hasMessage -> answerMessage()
            rom.milliseconds >= powerOffTime -> powerDown()
        }
    }

    /**
     * Runs the program for its share of one millisecond, or for the rest of it after a pause: at most [steps], none
     * while it waits. The program also stands still while On-Off is held down, because leJOS waits for its release.
     */
    override fun resumeProgram(steps: Int) {
        val standsStill = BrickButton.ON_OFF in buttons.pressed && !isPaused
        if (rom.milliseconds < waitUntil || standsStill || ending.shownFailure != null || hardware.asleep) return
        val share = if (isPaused) pausedSteps else steps
        pausedSteps = 0
        when (val status = run?.resume(share)) {
            null, ProgramStatus.Running -> return
            is ProgramStatus.Paused -> pausedSteps = status.stepsLeft
            is ProgramStatus.Waiting -> waitUntil = status.untilMilliseconds
            is ProgramStatus.ThreadFailed -> showThreadFailure(status.failure)
            ProgramStatus.Ended -> endProgram(stopped = false)
            is ProgramStatus.Failed -> showFailure(status.failure)
        }
    }

    /** Whether the shell handles the buttons. */
    private val isReady: Boolean get() = poweredOn && run == null && ending.shownFailure == null

    private fun onOffReleased() {
        when {
            !poweredOn -> powerUp()
            ending.shownFailure != null -> leaveFailure()
            run != null && runWasHeldWithOnOff -> endProgram()
            else -> powerDown()
        }
    }

    private fun selectNextSlot() {
        if (programs.isEmpty()) return
        val couldRun = selectedProgram != null
        selectedSlot = (selectedSlot + 1) % programs.size
        val canRun = selectedProgram != null
        firmware.showSlot(selectedSlot, standingMan = canRun.takeIf { it != couldRun })
        startIdleTime()
    }

    private fun startProgram() {
        selectedProgram?.let { start(it, isSnippet = false) }
    }

    private fun start(program: RcxProgram, isSnippet: Boolean) {
        this.isSnippet = isSnippet
        ending.forget()
        firmware.showRunning()
        waitUntil = rom.milliseconds
        hardware.expectations.place = { (run?.sourceLine ?: 0) to run?.sourceFile }
        hardware.expectations.startRun()
        run = program.start(rom)
    }

    private fun endProgram(stopped: Boolean = true) {
        leaveProgram()
        ending.ended(stopped, hardware.motors.states)
        firmware.controlMotors(MotorMode.BRAKE)
        showReady(SystemSounds.TWO_BEEPS)
    }

    /** A real brick keeps the motors running until On-Off is pressed; here the brick brakes them at once. */
    private fun showFailure(failure: ProgramFailure) {
        leaveProgram()
        ending.failed(failure)
        firmware.controlMotors(MotorMode.BRAKE)
        firmware.play(SystemSounds.BUZZ)
        firmware.showFailure(failure)
    }

    /** The program stands still while the failure is shown. */
    private fun showThreadFailure(failure: ProgramFailure) {
        ending.threadFailed(failure)
        firmware.play(SystemSounds.BUZZ)
        firmware.showFailure(failure)
    }

    /** Returns to the start screen, or resumes the rest of the program. */
    private fun leaveFailure() {
        ending.leaveFailure()
        if (run == null) showReady(SystemSounds.TWO_BEEPS)
    }

    private val selectedProgram: RcxProgram? get() = programs.getOrNull(selectedSlot)

    private fun showReady(sound: Int) {
        firmware.play(sound)
        firmware.showReady(selectedSlot, selectedProgram != null)
        startIdleTime()
    }

    private fun answerMessage() {
        when (mailbox.answer()) {
            ShellMailbox.ShellAction.NONE -> startIdleTime()

            ShellMailbox.ShellAction.START -> if (selectedProgram == null) {
                showReady(SystemSounds.TWO_BEEPS)
            } else {
                startProgram()
            }

            ShellMailbox.ShellAction.UNKNOWN -> showReady(SystemSounds.TWO_BEEPS)
        }
    }

    private fun startIdleTime() {
        powerOffTime = rom.milliseconds + IDLE_MILLISECONDS
    }

    private fun leaveProgram() {
        if (hardware.serial.line.isActive) firmware.initializeSerial()
        previousWarnings = warnings
        run = null
        ending.leaveFailure()
        pausedSteps = 0
        pressedInShell.clear()
    }

    private fun powerUp() {
        if (isSwitchingOff) finishSwitchingOff()
        hardware.wake()
        poweredOn = true
        firmware.initialize()
        showReady(SystemSounds.TWO_BEEPS)
    }

    private fun powerDown() {
        leaveProgram()
        ending.clear()
        poweredOn = false
        isSwitchingOff = true
        firmware.controlMotors(MotorMode.FLOAT)
        firmware.playNow(SystemSounds.BEEP)
        firmware.showNothing()
    }

    /** Shuts the firmware down after the last beep. */
    private fun finishSwitchingOff() {
        isSwitchingOff = false
        firmware.shutDown()
    }

    private companion object {
        /** Eight minutes. Source: leJOS `main.c`. */
        const val IDLE_MILLISECONDS = 8L * 60 * 1000
    }
}
