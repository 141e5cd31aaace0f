package robotran.nxt.shell

import robotran.brick.controls.BrickButton
import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.Drawing
import robotran.nxt.display.NxtDisplay
import robotran.nxt.hardware.MotorPorts
import robotran.nxt.log.CallOrigin
import robotran.nxt.messages.NxtMessages
import robotran.nxt.natives.NxtHardware
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.nxt.state.ExceptionView
import robotran.nxt.state.MenuView

/** Handles the buttons while no program runs, starts and ends programs, and shows what has gone wrong. */
internal class NxtShell(
    private val programs: List<BrickProgram?>,
    private val hardware: NxtHardware,
    private val nxt: Nxt,
    messages: NxtMessages,
    firstSlot: Int,
) {
    private val settings = MenuSettings(firstSlot)
    private val menu = NxtMenu(
        hardware.radio.name,
        programs.map { (it as? NxtProgram)?.name },
        settings,
        hardware.speaker,
        hardware.flash,
        millivolts = { hardware.battery.millivolts },
    )
    private val ending = RunEnding(messages)
    private var exceptionScreen: ExceptionScreen? = null
    private var run: ProgramRun? = null
    private var waitUntil = 0L
    private var pausedSteps = 0
    private var stopWasRequested = false
    private var memoryOfRun: DisplayMemory? = null
    private var previousWarnings: List<RuntimeWarning> = emptyList()
    private var splashUntil = 0L
    private var sleepTime = 0L

    /** Whether the current or last run is of a program that [runSnippet] got. */
    var isSnippet = false
        private set

    /** What the last program had drawn when it ended or was stopped; null after a failure or while one runs. */
    var leftByProgram: NxtDisplay? = null
        private set

    var poweredOn = false
        private set

    /** Index of the program that Run Default starts. */
    val selectedSlot: Int get() = settings.defaultSlot

    val runState: RunState
        get() {
            val run = run ?: return ending.state
            return ending.shownFailure?.let { RunState.Failed(it) } ?: RunState.Running(run.sourceLine, run.sourceFile)
        }

    val warnings: List<RuntimeWarning> get() = run?.warnings ?: previousWarnings
    val explanation: String? get() = ending.explanation
    val debuggableRun: DebuggableRun? get() = run as? DebuggableRun
    val isPaused: Boolean get() = pausedSteps > 0
    val menuView: MenuView? get() = if (isInMenu) menu.view else null
    val exceptionView: ExceptionView? get() = exceptionScreen?.view

    private val isInMenu: Boolean get() = poweredOn && splashUntil == 0L && run == null && exceptionScreen == null

    /** Starts for the first time, in the menu at once. */
    fun begin() {
        poweredOn = true
        showMenu()
    }

    fun pressed(button: BrickButton) {
        when {
            !poweredOn -> if (button == BrickButton.ENTER) powerUp()
            splashUntil > 0 -> return
            exceptionScreen != null -> pressedOnException(button)

            run != null -> if (button in STOP_BUTTONS &&
                hardware.buttons.pressed.containsAll(STOP_BUTTONS)
            ) {
                requestStop()
            }

            else -> pressedInMenu(button)
        }
    }

    fun stopProgram() {
        if (run != null) {
            endProgram(stopped = true)
        } else if (exceptionScreen != null) {
            leaveException()
        }
    }

    fun runSnippet(program: NxtProgram) {
        if (!poweredOn) powerUp()
        splashUntil = 0
        stopProgram()
        start(program, isSnippet = true)
    }

    /** Advances the shell by one millisecond. */
    fun tick() {
        when {
            splashUntil > 0 -> if (hardware.milliseconds >= splashUntil) endSplash()
            isInMenu && settings.sleepMinutes > 0 && hardware.milliseconds >= sleepTime -> powerDown()
        }
    }

    /**
     * Runs the program for its share of one millisecond, or for the rest of it after a pause: what the regulators leave
     * of [steps], and none while it waits.
     */
    fun resumeProgram(steps: Int) {
        val share = if (isPaused) pausedSteps else hardware.stepsLeft(steps)
        val run = run ?: return
        if (hardware.milliseconds < waitUntil || exceptionScreen != null || share == 0) return
        pausedSteps = 0
        when (val status = run.resume(share)) {
            ProgramStatus.Running -> Unit
            is ProgramStatus.Paused -> pausedSteps = status.stepsLeft
            is ProgramStatus.Waiting -> waitUntil = status.untilMilliseconds
            is ProgramStatus.ThreadFailed -> showThreadFailure(status.failure)
            ProgramStatus.Ended -> endProgram(stopped = stopWasRequested)
            is ProgramStatus.Failed -> showFailure(status.failure)
        }
        if (hardware.isToShutDown) powerDown()
    }

    private fun pressedInMenu(button: BrickButton) {
        startSleepTime()
        hardware.speaker.play(CLICK_HERTZ, CLICK_MILLISECONDS, settings.keyClick * CLICK_VOLUME, isFirmware = true)
        when (val action = menu.press(button)) {
            MenuAction.None -> showMenu()
            is MenuAction.Start -> (programs[action.slot] as? NxtProgram)?.let { start(it, isSnippet = false) }
            MenuAction.SwitchOff -> powerDown()
        }
    }

    private fun pressedOnException(button: BrickButton) {
        val screen = exceptionScreen ?: return
        if (button == BrickButton.ESCAPE) return leaveException()
        screen.press(button)
        hardware.display.showOwn(screen::draw)
    }

    /** The first time, a run that can end in order does so; the second time it is cut off. */
    private fun requestStop() {
        val endInOrder = hardware.onStopRequest
        if (endInOrder == null || stopWasRequested) return endProgram(stopped = true)
        stopWasRequested = true
        waitUntil = hardware.milliseconds
        endInOrder()
    }

    private fun start(program: NxtProgram, isSnippet: Boolean) {
        this.isSnippet = isSnippet
        ending.forget()
        leftByProgram = null
        resetHardware()
        hardware.display.clearForProgram()
        hardware.buttons.hidePressed()
        hardware.expectations.startRun()
        stopWasRequested = false
        waitUntil = hardware.milliseconds
        run = program.start(nxt)
    }

    private fun endProgram(stopped: Boolean) {
        keepDisplay()
        leaveRun()
        ending.ended(stopped, hardware.isDriving)
        resetHardware()
        showMenu()
    }

    private fun keepDisplay() {
        if (exceptionScreen != null) memoryOfRun?.let { hardware.display.memory = it }
        leftByProgram = hardware.display.drawn()
    }

    private fun showFailure(failure: ProgramFailure) {
        leaveRun()
        ending.failed(failure)
        resetHardware()
        show(failure)
    }

    /** The other threads stand still while the failure is shown. */
    private fun showThreadFailure(failure: ProgramFailure) {
        ending.threadFailed(failure)
        for (port in 0..<MotorPorts.PORTS) hardware.regulators[port].suspend()
        memoryOfRun = hardware.display.memory
        show(failure)
    }

    private fun show(failure: ProgramFailure) {
        val call = NxtCall.of(NxtNative.EXCEPTION, failure.exceptionNumber, failure.methodNumber)
        hardware.record(call, 0, CallOrigin.FIRMWARE)
        val screen = ExceptionScreen(failure)
        exceptionScreen = screen
        hardware.display.showOwn(screen::draw)
    }

    /** Back to the menu; if others still run, they are asked to end. */
    private fun leaveException() {
        exceptionScreen = null
        ending.leaveFailure()
        if (run == null) return showMenu()
        hardware.display.clearForProgram()
        memoryOfRun?.let { hardware.display.memory = it }
        requestStop()
    }

    private fun leaveRun() {
        previousWarnings = warnings
        run = null
        pausedSteps = 0
        exceptionScreen = null
        ending.leaveFailure()
    }

    private fun resetHardware() = hardware.reset { port ->
        hardware.record(NxtCall.controlMotor(port, 0, brakes = false), 0, CallOrigin.FIRMWARE)
    }

    private fun showMenu() {
        startSleepTime()
        hardware.display.showOwn(menu::draw)
    }

    private fun startSleepTime() {
        sleepTime = hardware.milliseconds + settings.sleepMinutes * MINUTE
    }

    private fun powerUp() {
        poweredOn = true
        menu.reset()
        splashUntil = hardware.milliseconds + SPLASH_MILLISECONDS
        hardware.display.showOwn { Drawing.drawString(it, "leJOS NXJ", SPLASH_COLUMN, SPLASH_ROW) }
    }

    private fun endSplash() {
        splashUntil = 0
        showMenu()
        val program = programs.getOrNull(settings.defaultSlot) as? NxtProgram
        val isHeldBack = BrickButton.LEFT in hardware.buttons.pressed
        if (settings.autoRun && program != null && !isHeldBack) start(program, isSnippet = false)
    }

    private fun powerDown() {
        if (run != null) keepDisplay()
        leaveRun()
        ending.clear()
        resetHardware()
        poweredOn = false
        splashUntil = 0
        hardware.record(NxtCall.of(NxtNative.SHUT_DOWN), 0, CallOrigin.FIRMWARE)
        hardware.display.showOwn { }
    }

    private companion object {
        const val SPLASH_MILLISECONDS = 300L
        const val SPLASH_COLUMN = 3
        const val SPLASH_ROW = 3
        const val MINUTE = 60_000L
        const val CLICK_HERTZ = 1_000
        const val CLICK_MILLISECONDS = 50
        const val CLICK_VOLUME = 10
        val STOP_BUTTONS = setOf(BrickButton.ENTER, BrickButton.ESCAPE)
    }
}
