package robotran.microbit

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
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.hardware.BoardHardware
import robotran.microbit.hardware.VirtualBoard
import robotran.microbit.messages.MicrobitMessages
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitProgram
import robotran.microbit.shell.MicrobitShell
import robotran.microbit.state.MicrobitState

/**
 * A virtual micro:bit with MicroPython on a [buggy]. It starts switched on; button A starts the selected program. Time
 * passes only in [tick].
 *
 * It knows no world: its environment tells what the sensors measure and reads what the wheels and the servo are told.
 *
 * @param hasPen whether a servo moves a pen.
 * @param programs one for each slot, at most [BrickProgram.MAX_PROGRAMS]; may be empty. null is a slot without a
 * runnable program, and so is a program for another kind of brick.
 * @param messages the language of the log and of [MicrobitState.explanation].
 * @param firstSlot index of the program that is selected at first.
 */
class MicrobitBrick(
    val model: MicrobitModel,
    val buggy: Buggy,
    hasPen: Boolean,
    programs: List<BrickProgram?>,
    messages: MicrobitMessages,
    firstSlot: Int = 0,
) : Brick {
    init {
        require(programs.size <= BrickProgram.MAX_PROGRAMS && firstSlot in 0 until maxOf(1, programs.size)) {
            "There is no slot for each program."
        }
    }

    private val hardware = BoardHardware(model, buggy, messages)

    /** The seam, for tests that call the board as a program does. */
    internal val board: Microbit = VirtualBoard(hardware)
    private val shell = MicrobitShell(programs, hardware, hasPen, board, messages, firstSlot)
    private val stepsPerMillisecond = MICROSECONDS / model.statementMicroseconds

    override val kind: BrickKind get() = model.kind

    override val state: MicrobitState
        get() = MicrobitState(
            model = model,
            milliseconds = hardware.milliseconds,
            screen = hardware.display.screen,
            motors = hardware.motors,
            pressed = hardware.buttons.pressed,
            selectedSlot = shell.selectedSlot,
            run = shell.runState,
            sounding = isSounding,
            ports = hardware.inputs,
            explanation = shell.explanation,
            isSnippet = shell.isSnippet,
            leftByProgram = shell.leftByProgram,
        )

    override val log: CallLog get() = hardware.log
    override val sounds: SoundTrack get() = hardware.speaker.track
    override val isSounding: Boolean get() = hardware.speaker.isSounding
    override val warnings: List<RuntimeWarning> get() = shell.warnings

    /** A buggy has its sensors built in; no program expects others. */
    override val expectedSensors: List<ExpectedSensor> get() = emptyList()
    override val isPaused: Boolean get() = shell.isPaused
    override val debuggableRun: DebuggableRun? get() = shell.debuggableRun

    override fun motor(port: MotorPort): MotorState =
        hardware.motors.find { it.port == port } ?: MotorState(port, MotorMode.FLOAT, power = 0)

    override fun press(button: BrickButton) {
        hardware.buttons.hold(button, down = true)?.let(shell::pressed)
    }

    override fun release(button: BrickButton) {
        hardware.buttons.hold(button, down = false)
    }

    /** A micro:bit does not measure it. */
    override fun setBattery(millivolts: Int) = Unit

    override fun stopProgram() = shell.stopProgram()

    override fun runSnippet(program: BrickProgram) {
        if (program is MicrobitProgram && program.kind == kind) shell.runSnippet(program)
    }

    /** Tells which sensors of the buggy are on its ports, by their numbers from 1. */
    fun plug(sensors: Map<Int, MicrobitSensor>) = hardware.plug(sensors)

    /** Sets what the line sensor number [line], from 0, measures from now on: percent of the light of white paper. */
    fun measureLine(line: Int, percent: Int) = hardware.measureLine(line, percent)

    /** Sets what the distance sensor hears from now on: whole centimetres up to 254; 255 for nothing. */
    fun measureDistance(centimetres: Int) = hardware.measureDistance(centimetres)

    /** Sets the light on the lights of the board, 0..255. */
    fun measureLight(level: Int) {
        hardware.lightLevel = level
    }

    /** Sets what the microphone hears, 0..255. */
    fun measureSound(level: Int) {
        hardware.soundLevel = level
    }

    override fun tick() {
        if (!isPaused) hardware.tick()
        shell.resumeProgram(stepsPerMillisecond)
    }

    private companion object {
        /** In a millisecond. */
        const val MICROSECONDS = 1_000
    }
}
