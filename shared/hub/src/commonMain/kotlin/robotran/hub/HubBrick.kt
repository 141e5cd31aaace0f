package robotran.hub

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
import robotran.hub.hardware.HubHardware
import robotran.hub.hardware.VirtualHub
import robotran.hub.messages.HubMessages
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.hub.model.HubMotorKind
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubProgram
import robotran.hub.program.HubReading
import robotran.hub.program.LightMode
import robotran.hub.shell.HubShell
import robotran.hub.state.HubState

/**
 * A virtual hub with Pybricks, of any [model]. It starts switched on; the button in the middle starts the selected
 * program and, on hubs of Powered Up, stops it. Time passes only in [tick].
 *
 * The hub knows no world: its environment plugs in motors and sensors, tells how far motors have turned and what sensors
 * measure, and reads what motors are told. When a program ends, its motors roll.
 *
 * @param programs one for each slot, at most [BrickProgram.MAX_PROGRAMS]; may be empty. null is a slot without a
 * runnable program, and so is a program for another kind of brick.
 * @param messages the language of the log and of [HubState.explanation].
 * @param firstSlot index of the program that is selected at first.
 */
class HubBrick(val model: HubModel, programs: List<BrickProgram?>, messages: HubMessages, firstSlot: Int = 0) : Brick {
    init {
        require(programs.size <= BrickProgram.MAX_PROGRAMS && firstSlot in 0 until maxOf(1, programs.size)) {
            "There is no slot for each program."
        }
    }

    private val hardware = HubHardware(model, messages)

    /** The seam, for tests that call the hub as a program does. */
    internal val hub: Hub = VirtualHub(hardware)
    private val shell = HubShell(programs, hardware, hub, messages, firstSlot)

    override val kind: BrickKind get() = model.kind

    override val state: HubState
        get() = HubState(
            model = model,
            milliseconds = hardware.milliseconds,
            poweredOn = true,
            screen = hardware.display.screen,
            motors = hardware.motorStates,
            pressed = hardware.buttons.pressed,
            selectedSlot = shell.selectedSlot,
            run = shell.runState,
            sounding = isSounding,
            ports = hardware.inputs.states,
            motorDegrees = hardware.motorDegrees,
            batteryMillivolts = hardware.batteryMillivolts,
            explanation = shell.explanation,
            isSnippet = shell.isSnippet,
            light = hardware.light,
            heading = hardware.heading?.toInt(),
            leftByProgram = shell.leftByProgram,
        )

    override val log: CallLog get() = hardware.log
    override val sounds: SoundTrack get() = hardware.speaker.track
    override val isSounding: Boolean get() = hardware.speaker.isSounding
    override val warnings: List<RuntimeWarning> get() = shell.warnings
    override val expectedSensors: List<ExpectedSensor> get() = hardware.inputs.expected
    override val isPaused: Boolean get() = shell.isPaused
    override val debuggableRun: DebuggableRun? get() = shell.debuggableRun

    override fun motor(port: MotorPort): MotorState =
        hardware.motor(HubPort.of(port))?.state ?: MotorState(port, MotorMode.FLOAT, power = 0)

    /** Whether a controller sets the power of [port], and so makes up for a weak motor or battery. */
    fun isControlled(port: MotorPort): Boolean = hardware.motor(HubPort.of(port))?.isControlled == true

    override fun press(button: BrickButton) {
        hardware.buttons.hold(button, down = true)?.let(shell::pressed)
    }

    override fun release(button: BrickButton) {
        hardware.buttons.hold(button, down = false)
    }

    override fun setBattery(millivolts: Int) {
        hardware.batteryMillivolts = millivolts
    }

    override fun stopProgram() = shell.stopProgram()

    override fun runSnippet(program: BrickProgram) {
        if (program is HubProgram && program.kind == kind) shell.runSnippet(program)
    }

    /** Plugs a motor into [port], or takes it out. */
    fun plugMotor(port: MotorPort, kind: HubMotorKind?) {
        hardware.motor(HubPort.of(port))?.plugged = kind
    }

    /** Plugs a sensor into [port], or takes it out. */
    fun plugSensor(port: HubPort, kind: HubDeviceKind?, mode: LightMode = LightMode.REFLECTION) =
        hardware.inputs.plug(port, kind, mode)

    /** Sets how far the motor at [port] has turned since the beginning of time, clockwise positive. */
    fun setMotorDegrees(port: MotorPort, degrees: Double) {
        hardware.motor(HubPort.of(port))?.turnTo(degrees)
    }

    /** Sets what the sensor at [port] measures from now on. */
    fun measure(port: HubPort, reading: HubReading) = hardware.inputs.measure(port, reading)

    /** Sets how far the hub has turned to the right since the beginning of time, degrees. */
    fun setTurned(degrees: Double) {
        hardware.turned = degrees
    }

    override fun tick() {
        if (!isPaused) hardware.tick()
        shell.resumeProgram(STEPS_PER_MILLISECOND)
    }

    companion object {
        /** Steps of a program per millisecond: a hub does 10,000 to 50,000 simple ones a second (estimate). */
        const val STEPS_PER_MILLISECOND = 30
    }
}
