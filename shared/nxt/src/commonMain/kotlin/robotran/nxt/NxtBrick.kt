package robotran.nxt

import robotran.brick.Brick
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallLog
import robotran.brick.program.BrickProgram
import robotran.brick.program.DebuggableRun
import robotran.brick.program.RuntimeWarning
import robotran.brick.sensors.ExpectedSensor
import robotran.brick.sound.SoundTrack
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.hardware.Clock
import robotran.nxt.hardware.I2cDevice
import robotran.nxt.hardware.MotorPorts
import robotran.nxt.hardware.NxtColour
import robotran.nxt.hardware.SensorPortState
import robotran.nxt.messages.NxtMessages
import robotran.nxt.natives.NxtHardware
import robotran.nxt.natives.VirtualNxt
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtProgram
import robotran.nxt.shell.NxtShell
import robotran.nxt.state.LinkView
import robotran.nxt.state.NxtState
import robotran.nxt.storage.NxtFile

/**
 * A virtual NXT with the firmware and menu of leJOS NXJ. It starts switched on, in its menu, with Run Default marked,
 * so that [BrickButton.ENTER] starts the first program. Time passes only in [tick].
 *
 * While a program runs, ENTER and ESCAPE pressed together end it. When a program ends, the brick lets its motors roll,
 * ends the sound and takes the power from the sensors. An exception that nobody catches is shown until ESCAPE is
 * pressed. Without a key for two minutes, the brick switches itself off; ENTER switches it on.
 *
 * @param programs the files of the menu, at most [BrickProgram.MAX_PROGRAMS]; may be empty. null is a slot without a
 * runnable program, and so is a program for another kind of brick.
 * @param network the radio between bricks. With the default, the brick is alone.
 * @param name the name by which other robots know it.
 * @param messages the language of the log and of [NxtState.explanation].
 * @param firstSlot index of the program that Run Default starts.
 * @param files what programs have written into the flash memory before.
 */
class NxtBrick(
    programs: List<BrickProgram?>,
    network: BluetoothNetwork = BluetoothNetwork(),
    name: String = DEFAULT_NAME,
    messages: NxtMessages,
    firstSlot: Int = 0,
    files: List<NxtFile> = emptyList(),
) : Brick {
    init {
        require(programs.size <= BrickProgram.MAX_PROGRAMS && firstSlot in 0 until maxOf(1, programs.size)) {
            "There is no slot for each program."
        }
    }

    private val hardware = NxtHardware(network, name, messages, files)

    /** The seam, for tests that call the brick as a program does. */
    internal val nxt: Nxt = VirtualNxt(hardware)
    private val shell = NxtShell(programs, hardware, nxt, messages, firstSlot)
    private val parts = NxtStateParts(hardware)

    init {
        shell.begin()
    }

    override val kind: BrickKind get() = BrickKind.NXT

    override val state: NxtState
        get() = NxtState(
            milliseconds = hardware.milliseconds,
            poweredOn = shell.poweredOn,
            display = hardware.display.glass,
            motors = hardware.motors.states,
            pressed = hardware.buttons.pressed,
            selectedSlot = shell.selectedSlot,
            run = shell.runState,
            sounding = isSounding,
            sensorPorts = parts.sensorPorts,
            motorDegrees = parts.motorDegrees,
            batteryMillivolts = hardware.battery.millivolts,
            explanation = shell.explanation,
            isSnippet = shell.isSnippet,
            isSending = hardware.radio.isSending,
            contrast = hardware.display.contrast,
            volume = hardware.speaker.setting,
            menu = shell.menuView,
            exception = shell.exceptionView,
            bluetooth = parts.links,
            leftByProgram = shell.leftByProgram,
            files = hardware.flash.files,
        )

    override val log: CallLog get() = hardware.log
    override val sounds: SoundTrack get() = hardware.speaker.track
    override val isSounding: Boolean get() = hardware.speaker.sounding
    override val warnings: List<RuntimeWarning> get() = shell.warnings
    override val expectedSensors: List<ExpectedSensor> get() = hardware.expectations.all
    override val isPaused: Boolean get() = shell.isPaused
    override val debuggableRun: DebuggableRun? get() = shell.debuggableRun

    /** The clock, for devices that are plugged in. */
    val clock: Clock = Clock { hardware.milliseconds }

    override val loudness: Int get() = hardware.speaker.loudness

    override fun motor(port: MotorPort): MotorState = hardware.motors.states[port.ordinal]

    /** Whether a regulator sets the power of [port], and so makes up for a weak motor or battery. */
    fun isRegulated(port: MotorPort): Boolean = hardware.regulators[port.ordinal].isActive

    override fun press(button: BrickButton) {
        if (hardware.buttons.hold(button, down = true)) shell.pressed(button)
    }

    override fun release(button: BrickButton) {
        hardware.buttons.hold(button, down = false)
    }

    override fun setBattery(millivolts: Int) = hardware.battery.measure(millivolts)

    override fun stopProgram() = shell.stopProgram()

    override fun runSnippet(program: BrickProgram) {
        if (program is NxtProgram) shell.runSnippet(program)
    }

    /**
     * Sets how far the hub of [port] has turned since the beginning of time. The counter follows every 2 milliseconds.
     */
    fun setHubDegrees(port: MotorPort, degrees: Int) = hardware.motors.setHubDegrees(port.ordinal, degrees)

    /**
     * Sets what the analog pin of a sensor port measures from now on; taken every 3 milliseconds.
     *
     * @param port 0..3 for the ports 1 to 4.
     * @param raw 0..1023; other values are clamped. An open port measures 1023.
     * @param unitValue what the sensor measures in the unit of its kind, where [raw] alone does not tell; null while it
     * is off.
     */
    fun setAnalog(port: Int, raw: Int, unitValue: Int? = null) = hardware.sensors[port].measure(raw, unitValue)

    /** Sets what a colour sensor at [port], 0..3, sees from now on; taken every 3 milliseconds. */
    fun setColour(port: Int, colour: NxtColour) = hardware.sensors[port].measure(colour)

    /** Takes at once what the analog pins and colour sensors measure, as a brick has that is switched on. */
    fun samplePins() = hardware.sensors.forEach { it.sample() }

    /** Plugs [device] into [port], 0..3, or nothing that sends bytes. */
    fun connect(port: Int, device: I2cDevice?) {
        hardware.sensors[port].i2c.device = device
    }

    /** A sensor port, 0..3, as its program has set it. The same object while nothing changes. */
    fun sensorPort(port: Int): SensorPortState = hardware.sensors[port].state

    override fun tick() {
        if (!isPaused) {
            hardware.tick()
            shell.tick()
        }
        shell.resumeProgram(STEPS_PER_MILLISECOND)
    }

    companion object {
        /** Steps of a program per millisecond. A step is ten byte codes, of which an NXT does about 300 (estimate). */
        const val STEPS_PER_MILLISECOND = 30

        /** The name of a brick that nobody has named. */
        const val DEFAULT_NAME = "NXT"
    }
}

/** Parts of the state that are the same objects as before while nothing changes, since many states are kept. */
private class NxtStateParts(private val hardware: NxtHardware) {
    var sensorPorts: List<SensorPortState> = hardware.sensors.map { it.state }
        get() {
            val isSame = field.indices.all { field[it] === hardware.sensors[it].state }
            if (!isSame) field = hardware.sensors.map { it.state }
            return field
        }
        private set

    var motorDegrees: List<Int> = List(MotorPorts.PORTS) { 0 }
        get() {
            val isSame = field.indices.all { field[it] == hardware.motors.tachoCount(it) }
            if (!isSame) field = List(MotorPorts.PORTS) { hardware.motors.tachoCount(it) }
            return field
        }
        private set

    var links: List<LinkView> = emptyList()
        get() {
            val now = hardware.radio.links
            val isSame = now.size == field.size &&
                now.indices.all { now[it].status == field[it].status && now[it].partner == field[it].partner }
            if (!isSame) field = now.map { LinkView(it.number, it.partner, it.status) }
            return field
        }
        private set
}
