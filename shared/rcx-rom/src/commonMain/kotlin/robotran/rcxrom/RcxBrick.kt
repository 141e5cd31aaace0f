package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.log.CallLog
import robotran.brick.program.DebuggableRun
import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sound.SoundTrack
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.messages.EnglishBrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.shell.Shell
import robotran.rcxrom.state.InfraredState
import robotran.rcxrom.state.RcxState

/**
 * A virtual RCX with its firmware. It starts switched on, as if On-Off had been released at millisecond 0. To start the
 * first program, press and release [BrickButton.RUN]. Time passes only in [tick].
 *
 * While no program runs, the buttons work as in the leJOS shell: Prgm selects the next program, Run starts it on
 * release, On-Off switches the brick off on release, and on again. After eight minutes without input the brick switches
 * itself off. While a program runs, View, Prgm and Run belong to the program. On-Off switches the brick off, or ends
 * the program if Run is held down as well. When a program ends, the brick brakes its motors. The firmware does all this
 * through ROM calls, which appear in the [log].
 *
 * When a program fails, the display shows the failure as leJOS shows an uncaught exception, until On-Off is pressed and
 * released.
 *
 * @param programs the program slots, at most [MAX_PROGRAMS]; may be empty. null is a slot without a runnable program.
 * @param firstSlot index of the program that Run starts if Prgm was not pressed.
 * @param air the medium for infrared light. With the default, the brick is alone.
 * @param messages the language of the log and of [RcxState.explanation].
 */
class RcxBrick(
    programs: List<RcxProgram?>,
    air: InfraredAir = InfraredAir(),
    messages: BrickMessages = EnglishBrickMessages,
    firstSlot: Int = 0,
) {
    init {
        require(programs.size <= MAX_PROGRAMS && firstSlot in 0 until maxOf(1, programs.size)) {
            "There is no slot for each program."
        }
    }

    /** The hardware parts, for tests that call the ROM as a program does. */
    internal val hardware = Hardware(air, messages)
    private val shell = Shell(programs, hardware, messages, firstSlot)

    /** All ROM calls so far, by the program and by the firmware. */
    val log: CallLog get() = hardware.log

    init {
        shell.begin()
    }

    /** The current state of the brick. */
    val state: RcxState
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
            shell.isImmediate,
        )

    /** The sounds the loudspeaker has played. */
    val sounds: SoundTrack get() = hardware.speaker.track

    /** A copy of the current memory, 64 KB. */
    fun memory(): MemorySnapshot = hardware.memory.snapshot()

    /** The command that [port] has; the same as in [state], but cheaper. */
    fun motor(port: MotorPort): MotorState = hardware.motors.states[port.ordinal]

    /**
     * What [port] really does in this millisecond: the command it had when the millisecond began, or [MotorMode.FLOAT]
     * in the milliseconds in which pulse-width modulation switches it off. A motor that a program drives for N
     * milliseconds is driven for N calls of [tick].
     */
    fun motorOutput(port: MotorPort): MotorMode = hardware.motors.output(port)

    /** Presses [button]. Does nothing if it is already down. */
    fun press(button: BrickButton) {
        if (hardware.buttons.hold(button, down = true)) shell.pressed(button)
    }

    /** Releases [button]. Does nothing if it is already up. */
    fun release(button: BrickButton) {
        if (hardware.buttons.hold(button, down = false)) shell.released(button)
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

    /**
     * Sets the battery voltage.
     *
     * @param millivolts as measured on a real brick, about 9000 for fresh batteries; clamped to the range of the
     * analogue converter.
     */
    fun setBattery(millivolts: Int) = hardware.measureBattery(Battery.rawOf(millivolts))

    /**
     * Ends the running program, if there is one. Also clears a displayed failure. A real brick has no single button for
     * this.
     */
    fun stopProgram() = shell.stopProgram()

    /**
     * Runs [program] at once, without a slot: as if it had been sent to the brick and Run pressed, except that sending
     * takes no time and the programs in the slots stay. First ends the running program, clears a displayed failure, or
     * switches the brick on.
     */
    fun runNow(program: RcxProgram) = shell.runNow(program)

    /**
     * Advances time by one millisecond. The firmware works first, then the program, until it waits or has used its
     * [STEPS_PER_MILLISECOND]. The clock continues while the brick is switched off. If a [StatementWatch] pauses the
     * program, the millisecond is not over yet: [isPaused] is true, and the next call continues the same millisecond.
     */
    fun tick() {
        if (!isPaused) {
            hardware.tick()
            shell.tick()
        }
        shell.resumeProgram(STEPS_PER_MILLISECOND)
    }

    /** Whether the program is paused in the middle of a millisecond. */
    val isPaused: Boolean get() = shell.isPaused

    /** The run for a debugger; null if no program runs or its language does not support debugging. */
    val debuggableRun: DebuggableRun? get() = shell.debuggableRun

    /** Warnings for the pupil about the running program or, if none runs, about the last one. */
    val remarks: List<RuntimeWarning> get() = shell.remarks

    /**
     * The sensors that the running program expects at the input ports or, if none runs, those of the last one; each
     * kind once per port, in the order in which the program said so.
     */
    val expectedSensors: List<ExpectedSensor> get() = hardware.expectations.all

    companion object {
        /**
         * Steps of a program per millisecond. An RCX executes ten to twenty thousand bytecodes a second (an estimate by
         * its users, there is no published measurement), and a Robolang statement compiles to about ten.
         */
        const val STEPS_PER_MILLISECOND = 2

        /** Max number of programs on the brick: a LEGO RCX shows as many program numbers. */
        const val MAX_PROGRAMS = 5
    }
}
