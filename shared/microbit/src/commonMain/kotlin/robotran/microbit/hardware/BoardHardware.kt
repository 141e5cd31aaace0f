package robotran.microbit.hardware

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.log.CallLog
import robotran.brick.sound.ToneSpeaker
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.buggy.PenServo
import robotran.microbit.display.BoardDisplay
import robotran.microbit.log.MicrobitLogEntry
import robotran.microbit.messages.MicrobitMeaning
import robotran.microbit.messages.MicrobitMessages
import robotran.microbit.messages.describe
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitError
import robotran.microbit.program.MicrobitNative
import robotran.microbit.state.MicrobitInput
import kotlin.math.abs

/** The parts of a micro:bit and its buggy, without what its buttons do. */
internal class BoardHardware(val model: MicrobitModel, val buggy: Buggy, private val messages: MicrobitMessages) {
    private val chip = BuggyChip(buggy)
    private val lines = buggy.lines.map { LineReader() }
    private var plugged: Map<Int, MicrobitSensor> = emptyMap()

    /** Virtual time, which passes only in [tick]. */
    var milliseconds = 0L
        private set

    val buttons = BoardButtons(model)
    val display = BoardDisplay()
    val speaker = ToneSpeaker { display.screen }
    val log = CallLog()
    var distance = NOTHING
        private set
    var lightLevel = 0
    var soundLevel = 0

    /** Whether a tone can be heard: by the board's own loudspeaker or a buzzer. */
    private val isLoud = model.hasSpeaker || buggy.buzzer != null

    /** The motors, the same list until one changes. */
    var motors: List<MotorState> = motorsNow()
        private set

    /** The ports for sensors, the same objects until one changes. */
    var inputs: List<MicrobitInput> = inputsNow()
        private set

    /** Whether a wheel turns. */
    val isDriving: Boolean get() = chip.left != 0 || chip.right != 0

    fun tick() {
        milliseconds++
        display.tick(milliseconds)
        speaker.tick(milliseconds)
    }

    fun isDark(line: Int): Boolean = lines.getOrNull(line)?.seesDark == true

    fun grey(line: Int): Int = lines.getOrNull(line)?.grey ?: 0

    /** Tells what is on the ports. */
    fun plug(sensors: Map<Int, MicrobitSensor>) {
        plugged = sensors
        inputs = inputsNow()
    }

    fun measureLine(line: Int, percent: Int) {
        lines.getOrNull(line)?.measure(percent)
        updateInputs()
    }

    fun measureDistance(centimetres: Int) {
        distance = centimetres
        updateInputs()
    }

    /** Performs [call] and adds it to the log. */
    fun perform(call: MicrobitCall, sourceLine: Int = 0, sourceFile: String? = null): MicrobitError? {
        val error = act(call)
        val meaning = if (error == null) meaningOf(call) else messages.refused(error.python)
        log.add(MicrobitLogEntry(milliseconds, call, error, sourceLine, sourceFile, meaning))
        return error
    }

    private fun act(call: MicrobitCall): MicrobitError? {
        val n = call.numbers
        if (n.size < call.native.parameters) return MicrobitError.INVALID_ARGUMENT
        when (call.native) {
            MicrobitNative.I2C_WRITE -> chip.write(n)?.let { return it }
            MicrobitNative.PIN_ANALOG -> chip.setPin(n[0], n[1])?.let { return it }
            MicrobitNative.PIN_DIGITAL -> chip.setPin(n[0], n[1] * FULL)?.let { return it }
            MicrobitNative.PIN_PERIOD -> if (n[1] <= 0) return MicrobitError.INVALID_ARGUMENT
            MicrobitNative.DISPLAY_SHOW -> if (!display.show(call.text.orEmpty())) return MicrobitError.INVALID_ARGUMENT
            MicrobitNative.DISPLAY_SCROLL -> display.scroll(call.text.orEmpty())
            MicrobitNative.DISPLAY_CLEAR -> display.clear()
            MicrobitNative.MUSIC_PITCH -> if (isLoud) speaker.beep(n[0], n[1])
            MicrobitNative.MUSIC_STOP -> speaker.stop()
            MicrobitNative.PRINT -> display.print(call.text.orEmpty())
        }
        val now = motorsNow()
        if (now != motors) motors = now
        return null
    }

    private fun meaningOf(call: MicrobitCall): String = messages.describe(
        call,
        when {
            chip.isServo(call) -> MicrobitMeaning.Servo(chip.servo ?: 0)
            isDriving || chip.isStop(call) -> MicrobitMeaning.Wheels(chip.left, chip.right)
            else -> MicrobitMeaning.SetUp
        },
    )

    private fun motorsNow(): List<MotorState> = listOf(
        wheel(MotorPort.A, chip.left),
        MotorPort.B.let { port ->
            val servo = chip.servo
            when {
                servo == null -> MotorState(port, MotorMode.FLOAT, power = 0)
                servo < PEN_MIDDLE -> MotorState(port, MotorMode.FORWARD, ALL)
                else -> MotorState(port, MotorMode.BACKWARD, ALL)
            }
        },
        wheel(MotorPort.C, chip.right),
    )

    /** A wheel without power stands as fast as it started: the drivers of most buggies brake a little. */
    private fun wheel(port: MotorPort, percent: Int) = MotorState(
        port,
        when {
            percent > 0 -> MotorMode.FORWARD
            percent < 0 -> MotorMode.BACKWARD
            else -> MotorMode.BRAKE
        },
        abs(percent),
    )

    private fun updateInputs() {
        val now = inputsNow()
        if (now != inputs) inputs = now
    }

    private fun inputsNow(): List<MicrobitInput> = List(model.kind.inputPorts) { index ->
        val sensor = plugged[index + 1]
        MicrobitInput(
            index + 1,
            sensor,
            when (sensor) {
                null -> 0
                MicrobitSensor.Sonar -> distance

                is MicrobitSensor.Line -> when {
                    buggy.lines[sensor.line].isGrey -> grey(sensor.line)
                    isDark(sensor.line) -> 0
                    else -> ALL
                }
            },
        )
    }

    companion object {
        /** Centimetres with nothing ahead. */
        const val NOTHING = 255

        private const val ALL = 100
        private const val FULL = 1023
        private const val PEN_MIDDLE = (PenServo.UP_DEGREES + PenServo.DOWN_DEGREES) / 2
    }
}
