package robotran.rcxrom

import robotran.brick.Brick
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLog
import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sound.SoundTrack
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxFirmware
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.RcxShell
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.shell.Shell
import robotran.rcxrom.state.InfraredState
import robotran.rcxrom.state.RcxFirmwareState
import robotran.rcxrom.state.RcxState

/**
 * A virtual RCX with its firmware. It starts as if On-Off had been released at millisecond 0.
 *
 * Its firmware is that of the selected program, see [RcxProgram.firmware]. If Prgm selects a program of another one, the
 * brick gets that: it begins anew.
 *
 * With leJOS's firmware, the buttons work as in the leJOS shell while no program runs: Prgm selects the next program, Run
 * starts it on release, On-Off switches the brick off on release, and on again. After eight minutes without input the
 * brick switches itself off. While a program runs, View, Prgm and Run belong to the program. On-Off switches the brick off, or ends
 * the program if Run is held down as well. When a program ends, the brick brakes its motors. The firmware does all this
 * through ROM calls, which appear in the [log].
 *
 * When a program fails, the display shows the failure as leJOS shows an uncaught exception, until On-Off is pressed and
 * released.
 *
 * @param programs the program slots, at most [BrickProgram.MAX_PROGRAMS]; may be empty. null is a slot without a
 * runnable program.
 * @param firstSlot index of the program that Run starts if Prgm was not pressed.
 * @param air the medium for infrared light. With the default, the brick is alone.
 * @param messages the language of the log and of [RcxState.explanation].
 */
class RcxBrick(
    private val programs: List<RcxProgram?>,
    air: InfraredAir = InfraredAir(),
    private val messages: BrickMessages,
    firstSlot: Int = 0,
) : Brick {
    init {
        require(programs.size <= BrickProgram.MAX_PROGRAMS && firstSlot in 0 until maxOf(1, programs.size)) {
            "There is no slot for each program."
        }
    }

    /** The hardware parts, for tests that call the ROM as a program does. */
    internal val hardware = Hardware(air, messages)
    private var firmware: RcxFirmware? = programs.getOrNull(firstSlot)?.firmware
    private var shell: RcxShell = load(firstSlot)

    override val kind: BrickKind get() = BrickKind.RCX

    /** All ROM calls so far, by the program and by the firmware. */
    override val log: CallLog get() = hardware.log

    init {
        shell.begin()
    }

    override val state: RcxState
        get() = RcxState(
            hardware.milliseconds,
            shell.poweredOn,
            hardware.lcd.glass,
            hardware.motors.states,
            hardware.buttons.pressed,
            shell.selectedSlot,
            shell.runState,
            hardware.speaker.sounding,
            hardware.sensors.states,
            Battery.millivolts(hardware.batteryRaw),
            InfraredState(hardware.serial.isSending || hardware.serial.line.isSending, hardware.serial.range),
            shell.explanation,
            shell.isSnippet,
        )

    /** What the firmware knows, such as its variables; null for leJOS's. */
    val firmwareState: RcxFirmwareState? get() = shell.firmwareState

    override val sounds: SoundTrack get() = hardware.speaker.track

    override val isSounding: Boolean get() = hardware.speaker.sounding

    /** A copy of the current memory, 64 KB. */
    fun memory(): MemorySnapshot = hardware.memory.snapshot()

    override fun motor(port: MotorPort): MotorState = hardware.motors.states[port.ordinal]

    /**
     * What [port] really does in this millisecond: the command it had when the millisecond began, or [MotorMode.FLOAT]
     * in the milliseconds in which pulse-width modulation switches it off. A motor that a program drives for N
     * milliseconds is driven for N calls of [tick].
     */
    fun motorOutput(port: MotorPort): MotorMode = hardware.motors.output(port)

    override fun press(button: BrickButton) {
        if (button in kind.buttons && hardware.buttons.hold(button, down = true)) changeSlot { shell.pressed(button) }
    }

    override fun release(button: BrickButton) {
        if (button in kind.buttons && hardware.buttons.hold(button, down = false)) changeSlot { shell.released(button) }
    }

    /**
     * Sets the raw value that the input [port] measures from now on. The firmware reads it every three milliseconds.
     *
     * @param port 0..2 for the ports 1..3.
     * @param raw 0..1023; other values are clamped. An open port measures [SensorCode.OPEN_RAW].
     */
    fun setRawSensorValue(port: Int, raw: Int) = hardware.sensors.measure(port, raw)

    /** Whether the input [port], 0..2, is powered. A light sensor needs power for its lamp. */
    fun sensorIsActive(port: Int): Boolean = hardware.sensors.isActive(port)

    /** @param millivolts about 9000 for fresh batteries. */
    override fun setBattery(millivolts: Int) = hardware.measureBattery(Battery.rawOf(millivolts))

    override fun stopProgram() = shell.stopProgram()

    override fun runSnippet(program: BrickProgram) {
        if (program !is RcxProgram) return
        loadFirmwareOf(program)
        shell.runSnippet(program)
    }

    /** Runs [work] of the shell, which may select a slot. */
    private inline fun changeSlot(work: () -> Unit) {
        val slotBefore = shell.selectedSlot
        work()
        val slot = shell.selectedSlot
        if (slot != slotBefore) programs.getOrNull(slot)?.let { loadFirmwareOf(it) }
    }

    private fun loadFirmwareOf(program: RcxProgram) {
        if (program.firmware == firmware) return
        shell.stopProgram()
        hardware.reset()
        firmware = program.firmware
        shell = load(shell.selectedSlot)
        shell.begin()
    }

    private fun load(slot: Int): RcxShell =
        firmware?.load(programs, slot, hardware) ?: Shell(programs, hardware, messages, slot)

    /** One millisecond: the program gets [STEPS_PER_MILLISECOND]. */
    override fun tick() {
        if (!isPaused) {
            hardware.tick()
            shell.tick()
        }
        shell.resumeProgram(STEPS_PER_MILLISECOND)
    }

    override val isPaused: Boolean get() = shell.isPaused

    override val debuggableRun: DebuggableRun? get() = shell.debuggableRun

    override val warnings: List<RuntimeWarning> get() = shell.warnings

    override val expectedSensors: List<ExpectedSensor> get() = hardware.expectations.all

    companion object {
        /**
         * Steps of a program per millisecond. An RCX executes ten to twenty thousand bytecodes a second (an estimate by
         * its users, there is no published measurement), and a Robolang statement compiles to about ten.
         */
        const val STEPS_PER_MILLISECOND = 2
    }
}
