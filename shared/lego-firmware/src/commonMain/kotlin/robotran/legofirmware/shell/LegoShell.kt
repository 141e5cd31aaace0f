package robotran.legofirmware.shell

import robotran.brick.controls.BrickButton
import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.state.RunState
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.legofirmware.run.FirmwareMachine
import robotran.legofirmware.run.FirmwareRun
import robotran.legofirmware.run.FirmwareState
import robotran.legofirmware.run.ProgramCode
import robotran.legofirmware.run.RemoteCommand
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.RcxShell
import robotran.rcxrom.program.ShellHardware

/**
 * What the buttons do under LEGO's firmware: Run starts the selected program, and stops it; Prgm selects the next slot;
 * View shows the next port; On-Off switches the brick off and on. All but On-Off act when they are pressed.
 *
 * @param slots null where there is no program for this firmware.
 * @param codeOf the code of a program that is sent to run at once; null if it is not for this firmware.
 */
internal class LegoShell(
    private val slots: List<ProgramCode?>,
    private val codeOf: (RcxProgram) -> ProgramCode?,
    firstSlot: Int,
    private val hardware: ShellHardware,
    private val messages: FirmwareRunMessages,
) : RcxShell {
    private val machine = FirmwareMachine(hardware.rom, messages)
    private val devices = machine.core.devices
    private val power = PowerSwitch(machine, hardware)
    private var run: FirmwareRun? = null
    private var pausedSteps = 0
    private var lastState: RunState = RunState.Idle
    private var lastWarnings: List<RuntimeWarning> = emptyList()
    private var emptySlot: Int? = null

    init {
        devices.slot = firstSlot
    }

    override val poweredOn: Boolean get() = power.isOn

    override var isSnippet = false
        private set

    override val selectedSlot: Int get() = devices.slot

    override val runState: RunState
        get() = run?.let { RunState.Running(it.sourceLine, it.sourceFile) } ?: lastState

    override val warnings: List<RuntimeWarning> get() = run?.warnings ?: lastWarnings

    override val explanation: String?
        get() {
            val emptySlot = emptySlot
            return when {
                emptySlot != null -> messages.emptySlot(emptySlot + 1)
                lastState == RunState.Ended(stopped = false) && run == null && drives -> messages.motorsStayOn()
                else -> null
            }
        }

    override val debuggableRun: DebuggableRun? get() = run

    override val firmwareState: FirmwareState get() = machine.state

    override val isPaused: Boolean get() = pausedSteps > 0

    override fun begin() {
        power.begin()
    }

    override fun pressed(button: BrickButton) {
        if (button == BrickButton.ON_OFF) hardware.wake()
        if (!poweredOn) return
        power.noteUse()
        when (button) {
            BrickButton.RUN -> if (run == null) startSelected() else stopProgram()
            BrickButton.VIEW -> machine.viewNext()
            BrickButton.PRGM -> if (run == null) selectNextSlot()
            else -> Unit
        }
    }

    override fun released(button: BrickButton) {
        if (button != BrickButton.ON_OFF) return
        if (poweredOn) powerDown() else power.switchOn()
    }

    override fun stopProgram() {
        hardware.wake()
        if (!poweredOn) return
        machine.stop()
        if (run != null) endRun(stopped = true)
    }

    override fun runSnippet(program: RcxProgram) {
        val code = codeOf(program) ?: return
        hardware.wake()
        if (run != null) stopProgram()
        if (!poweredOn) power.switchOn()
        start(code, isSnippet = true)
    }

    override fun tick() {
        power.tick()
        if (poweredOn && !hardware.isAsleep) runFirmware()
    }

    override fun resumeProgram(steps: Int) {
        if (hardware.isAsleep) return
        val share = if (isPaused) pausedSteps else steps
        pausedSteps = 0
        when (val status = run?.resume(share)) {
            is ProgramStatus.Paused -> pausedSteps = status.stepsLeft
            ProgramStatus.Ended -> endRun(stopped = false)
            else -> Unit
        }
    }

    private val drives: Boolean get() = (0 until MOTORS).any { devices.outputs.drivesForward(it) != null }

    private fun runFirmware() {
        machine.tick()
        when (val command = machine.takeRemoteCommand()) {
            is RemoteCommand.Start -> startFromAfar(command.slot)
            RemoteCommand.Stop -> stopProgram()
            null -> Unit
        }
        if (machine.takeActivity()) power.noteUse()
        if (power.isOffDue) powerDown()
    }

    private fun startFromAfar(slot: Int) {
        if (run != null) stopProgram()
        machine.select(slot)
        startSelected()
    }

    private fun startSelected() {
        val code = slots.getOrNull(devices.slot)
        if (code != null) {
            start(code, isSnippet = false)
        } else {
            emptySlot = devices.slot
            power.play(BUZZ)
        }
    }

    private fun start(code: ProgramCode, isSnippet: Boolean) {
        this.isSnippet = isSnippet
        emptySlot = null
        pausedSteps = 0
        hardware.startExpectations { (run?.sourceLine ?: 0) to run?.sourceFile }
        run = FirmwareRun(machine, code)
    }

    private fun endRun(stopped: Boolean) {
        lastWarnings = warnings
        lastState = RunState.Ended(stopped)
        run = null
        pausedSteps = 0
    }

    private fun selectNextSlot() {
        emptySlot = null
        power.play(CLICK)
        machine.select((devices.slot + 1) % BrickProgram.MAX_PROGRAMS)
    }

    private fun powerDown() {
        if (run != null) {
            machine.stop()
            endRun(stopped = true)
        }
        lastState = RunState.Idle
        emptySlot = null
        power.switchOff()
    }

    private companion object {
        const val MOTORS = 3

        /** System sounds of the ROM. */
        const val CLICK = 0
        const val BUZZ = 4
    }
}
