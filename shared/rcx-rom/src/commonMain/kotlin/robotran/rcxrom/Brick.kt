package robotran.rcxrom

import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.controls.MotorMode
import robotran.rcxrom.controls.MotorPort
import robotran.rcxrom.controls.MotorState
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.log.RomLog
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.messages.EnglishBrickMessages
import robotran.rcxrom.program.DebuggableRun
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.shell.Shell
import robotran.rcxrom.sound.SoundTrack
import robotran.rcxrom.state.BrickState
import robotran.rcxrom.state.InfraredState

/**
 * A virtual RCX with its firmware. It begins switched on, just as if somebody had let go of On-Off at its millisecond
 * 0, so that pressing and releasing [BrickButton.RUN] is all that is needed to start the first program. Time passes
 * only in [tick].
 *
 * While no program runs, the buttons do what they do in the leJOS shell: Prgm chooses the next program, Run starts it
 * when let go, On-Off switches the brick off when let go, and on again; after eight minutes in which nobody does
 * anything, it switches itself off. While a program runs, View, Prgm and Run belong to the program; On-Off switches the
 * brick off, or ends the program if Run is held down with it. When a program ends, its motors are braked. The firmware
 * does all this through ROM calls, too, so it can be read in the [log].
 *
 * A program that fails is shown as leJOS shows an exception that nobody catches, until On-Off is pressed and let go.
 *
 * @param programs the program slots, [MAX_PROGRAMS] at most; may be empty. A slot with null has no program that could
 * run.
 * @param firstSlot the program that Run starts as long as Prgm was not pressed, from 0.
 * @param air where its infrared light goes and comes from; in one of its own a brick is alone.
 * @param messages the language of the log and of [BrickState.explanation].
 */
class Brick(
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

    /** The parts themselves, for tests that call the ROM as a program does. */
    internal val hardware = Hardware(air, messages)
    private val shell = Shell(programs, hardware, messages, firstSlot)

    /** Every ROM call so far, of the program and of the firmware. */
    val log: RomLog get() = hardware.log

    init {
        shell.begin()
    }

    /** The brick as it is now. */
    val state: BrickState
        get() = BrickState(
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
            InfraredState(hardware.serial.isSending, hardware.serial.range),
            shell.explanation,
        )

    /** What the loudspeaker has played; to be listened to at any time, or never. */
    val sounds: SoundTrack get() = hardware.speaker.track

    /** The memory as it is now, a copy of 64 KB. */
    fun memory(): MemorySnapshot = hardware.memory.snapshot()

    /** What [port] is told to do; the same as in [state], but cheaper. */
    fun motor(port: MotorPort): MotorState = hardware.motors.states[port.ordinal]

    /**
     * What [port] really does in this millisecond: what it was told before the millisecond began, and [MotorMode.FLOAT]
     * in the milliseconds in which its pulsed power switches it off. A motor driven for N milliseconds by a program is
     * driven for N calls of [tick].
     */
    fun motorOutput(port: MotorPort): MotorMode = hardware.motors.output(port)

    /** A finger goes down on [button]. Does nothing if it is down already. */
    fun press(button: BrickButton) {
        if (hardware.buttons.hold(button, down = true)) shell.pressed(button)
    }

    /** The finger comes off [button]. Does nothing if it is up already. */
    fun release(button: BrickButton) {
        if (hardware.buttons.hold(button, down = false)) shell.released(button)
    }

    /**
     * What the input [port] measures from now on, until it is told otherwise; the firmware reads it every three
     * milliseconds.
     *
     * @param port 0..2 for the ports 1..3.
     * @param raw 0..1023; what is beyond counts as the nearest of these. An open port measures [SensorCode.OPEN_RAW].
     */
    fun setRawSensorValue(port: Int, raw: Int) = hardware.sensors.measure(port, raw)

    /** Whether the input [port], 0..2, is supplied with power, as a light sensor needs it to shine. */
    fun sensorIsActive(port: Int): Boolean = hardware.sensors.isActive(port)

    /**
     * What the batteries give from now on.
     *
     * @param millivolts as measured on a real brick, about 9000 when fresh; what the converter cannot tell counts as
     * the nearest it can.
     */
    fun setBattery(millivolts: Int) = hardware.measureBattery(Battery.rawOf(millivolts))

    /**
     * Ends the running program, if there is one, as no single button of a real brick does; ends the showing of a
     * failure, too.
     */
    fun stopProgram() = shell.stopProgram()

    /**
     * Lets one millisecond pass: first the firmware's work, then the program's, until it waits or its
     * [STEPS_PER_MILLISECOND] are used up. The clock goes on while the brick is switched off. If a [StatementWatch]
     * stops the program, the millisecond is not over yet: [isPaused] is true, and the next call goes on with the same
     * one.
     */
    fun tick() {
        if (!isPaused) {
            hardware.tick()
            shell.tick()
        }
        shell.resumeProgram(STEPS_PER_MILLISECOND)
    }

    /** Whether the program was stopped in the middle of a millisecond. */
    val isPaused: Boolean get() = shell.isPaused

    /** The run of the program, to be looked into; null if none runs or if its language cannot be looked into. */
    val debuggableRun: DebuggableRun? get() = shell.debuggableRun

    /** What a pupil should know about the running program or, if none runs, about the last one. */
    val remarks: List<RuntimeWarning> get() = shell.remarks

    companion object {
        /**
         * How many steps of a program fit into a millisecond: an RCX does ten to twenty thousand bytecodes a second (an
         * estimate of its users, nobody has published a measurement), and a statement of Robolang becomes about ten.
         */
        const val STEPS_PER_MILLISECOND = 2

        /** How many programs the brick can hold at once: as many as a LEGO RCX shows numbers for. */
        const val MAX_PROGRAMS = 5
    }
}
