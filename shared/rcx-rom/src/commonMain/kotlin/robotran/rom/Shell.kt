package robotran.rom

/**
 * The leJOS shell: what the buttons do, and how a program's run begins and ends. Source: leJOS `main.c`.
 *
 * @param buttons already hold what is pressed when [pressed] and [released] are called.
 */
internal class Shell(
    private val programs: List<RcxProgram>,
    private val rom: Rom,
    private val buttons: Buttons,
) {
    private val firmware = Firmware(rom)
    private var run: ProgramRun? = null
    private var waitUntil = 0L
    private var pausedSteps = 0
    private var endingState: RunState = RunState.Idle
    private val pressedInShell = mutableSetOf<BrickButton>()
    private var runWasHeldWithOnOff = false

    var poweredOn = false
        private set

    /** The program that Run starts, from 0. */
    var selectedSlot = 0
        private set

    val runState: RunState get() = run?.let { RunState.Running(it.sourceLine) } ?: endingState

    fun powerUp() {
        poweredOn = true
        selectedSlot = 0
        firmware.play(SystemSounds.TWO_BEEPS)
        firmware.showReady(selectedSlot, programs.isNotEmpty())
    }

    fun pressed(button: BrickButton) {
        if (button == BrickButton.ON_OFF) runWasHeldWithOnOff = false
        if (BrickButton.ON_OFF in buttons.pressed && BrickButton.RUN in buttons.pressed) runWasHeldWithOnOff = true
        if (!poweredOn || run != null) return
        pressedInShell += button
        if (button == BrickButton.PRGM) firmware.play(SystemSounds.BEEP)
    }

    fun released(button: BrickButton) {
        val wasPressedInShell = pressedInShell.remove(button)
        when {
            button == BrickButton.ON_OFF -> onOffReleased()
            !poweredOn || run != null || !wasPressedInShell -> return
            button == BrickButton.PRGM -> selectNextSlot()
            button == BrickButton.RUN -> startProgram()
        }
    }

    fun stopProgram() {
        if (run != null) endProgram(RunState.Ended(stopped = true), SystemSounds.TWO_BEEPS)
    }

    /** The run that can be looked into, if there is one. */
    val debuggableRun: DebuggableRun? get() = run as? DebuggableRun

    /** Whether the program stopped in the middle of its share of this millisecond. */
    val isPaused: Boolean get() = pausedSteps > 0

    /** The program's share of one millisecond, or what is left of it after a pause: at most [steps], none while it waits. */
    fun resumeProgram(steps: Int) {
        if (rom.milliseconds < waitUntil) return
        val share = if (isPaused) pausedSteps else steps
        pausedSteps = 0
        when (val status = run?.resume(share)) {
            null, ProgramStatus.Running -> return
            is ProgramStatus.Paused -> pausedSteps = status.stepsLeft
            is ProgramStatus.Waiting -> waitUntil = status.untilMilliseconds
            ProgramStatus.Ended -> endProgram(RunState.Ended(stopped = false), SystemSounds.TWO_BEEPS)
            is ProgramStatus.Failed -> endProgram(RunState.Failed(status.failure), SystemSounds.BUZZ)
        }
    }

    private fun onOffReleased() {
        when {
            !poweredOn -> powerUp()
            run != null && runWasHeldWithOnOff -> stopProgram()
            else -> powerDown()
        }
    }

    private fun selectNextSlot() {
        if (programs.isNotEmpty()) selectedSlot = (selectedSlot + 1) % programs.size
        firmware.showSlot(selectedSlot)
    }

    private fun startProgram() {
        val program = programs.getOrNull(selectedSlot) ?: return
        firmware.showRunning()
        waitUntil = rom.milliseconds
        run = program.start(rom)
    }

    private fun endProgram(state: RunState, systemSound: Int) {
        run = null
        pausedSteps = 0
        endingState = state
        pressedInShell.clear()
        firmware.controlMotors(MotorMode.BRAKE)
        firmware.play(systemSound)
        firmware.showReady(selectedSlot, programIsLoaded = true)
    }

    private fun powerDown() {
        poweredOn = false
        run = null
        pausedSteps = 0
        endingState = RunState.Idle
        pressedInShell.clear()
        firmware.controlMotors(MotorMode.FLOAT)
        firmware.playNow(SystemSounds.BEEP)
        firmware.showNothing()
    }
}
