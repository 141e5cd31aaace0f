package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubPort
import robotran.hub.program.Hub
import robotran.hub.program.HubCall
import robotran.hub.program.HubNative
import robotran.robolang.messages.RobolangRunMessages
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.SensorPorts
import robotran.robolang.robot.roundAsPython
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection

/** A robot with a hub that runs Pybricks. Makes the calls of the program's Python, in the same order. */
internal class HubDevice private constructor(
    private val robot: RobotTarget.Hub,
    private val uses: HubUses,
    private val calls: HubCalls,
    private val messages: RobolangRunMessages,
    private val senses: HubSenses,
) : RobotDevice,
    RobotSenses by senses {
    private val hub = calls.hub
    private val model = hub.model
    private val drive = HubDrive(robot, uses, calls)
    private val turns = mutableMapOf<MotorPort, Int>()
    private var isBlinking = false

    constructor(hub: Hub, robot: RobotTarget.Hub, uses: HubUses, messages: RobolangRunMessages) :
        this(robot, uses, HubCalls(hub, messages), messages, HubSenses(hub, uses))

    override val milliseconds: Long get() = hub.milliseconds
    override val collectsLists: Boolean get() = true
    override val isSetUp: Boolean get() = true
    override val isDriving: Boolean get() = drive.isMoving
    override val isPenMoving: Boolean get() = robot.pen?.let(::isTurning) ?: false
    override val longestTone: Int get() = Int.MAX_VALUE / MILLISECONDS_PER_HUNDREDTH
    override var outputMilliseconds = 0
        private set

    override fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit) {
        fun make(call: HubCall, line: Int) {
            at(line)
            calls.make(call, line)
        }
        for ((motor, line) in uses.motors) {
            val device = HubCall.device(HubDeviceKind.MOTOR, HubPort.of(motor), robot.isCounterclockwise(motor))
            make(device, line)
        }
        uses.baseLine?.let { make(driveBase(), it) }
        for ((port, line) in uses.sensors) {
            make(HubCall.device(robot.sensors.getValue(port), model.sensorPorts[port - 1]), line)
        }
        uses.middleButtonLine?.takeIf { model.stopButton == HubButton.CENTER }?.let { line ->
            val other = if (HubButton.BLUETOOTH in model.buttons) HubButton.BLUETOOTH.ordinal else NO_BUTTON
            make(HubCall.of(HubNative.SET_STOP_BUTTON, other), line)
        }
        if (model.kind.hasLetteredInputs) {
            for ((motor, line) in uses.motors.filterKeys { it in uses.counted }) {
                make(HubCall.on(HubNative.MOTOR_RESET_ANGLE, HubPort.of(motor), 0), line)
            }
        }
        if (!model.devices.choosesColors) return at(null)
        for (port in uses.coloured) {
            val colors = HubCall.detectableColors(model.sensorPorts[port - 1], HubFigures.COLOURS)
            make(colors, uses.sensors.getValue(port))
        }
        at(null)
    }

    private fun driveBase() = HubCall.driveBase(
        HubPort.of(robot.left),
        HubPort.of(robot.right),
        roundAsPython(robot.wheelDiameter * THOUSANDTHS).toInt(),
        roundAsPython(robot.track * THOUSANDTHS).toInt(),
    )

    override fun startMoving(direction: MoveDirection, sourceLine: Int) = drive.start(sign(direction), 0, sourceLine)

    override fun startTurning(direction: TurnDirection, sourceLine: Int) = drive.start(0, sign(direction), sourceLine)

    override fun stopDriving(sourceLine: Int) = drive.stop(sourceLine)

    override fun drive(direction: MoveDirection, distance: NumberValue, sourceLine: Int): Int {
        val sign = sign(direction) * HubFigures.MILLIMETRES_PER_CENTIMETRE
        drive.straight(times(distance, sign), sourceLine)
        return 0
    }

    override fun turn(direction: TurnDirection, angle: NumberValue, sourceLine: Int): Int {
        drive.turn(times(angle, sign(direction)), sourceLine)
        return 0
    }

    /** A later command has taken the place of a drive that is cut short. */
    override fun endDrive(sourceLine: Int) = Unit

    override fun startPen(position: PenPosition, sourceLine: Int): Int {
        val degrees = if (position == PenPosition.DOWN) HubFigures.PEN_DEGREES else 0
        robot.pen?.let { pen ->
            calls.on(HubNative.MOTOR_RUN_TARGET, pen, sourceLine, HubFigures.PEN_SPEED, degrees, 0)
            remember(pen)
        }
        return 0
    }

    override fun stopPen(sourceLine: Int) = Unit

    override fun setPower(side: PowerSide, power: Int, sourceLine: Int) = drive.setPower(side, power, sourceLine)

    override fun setPower(motor: MotorPort, power: Int, sourceLine: Int) = drive.setPower(motor, power, sourceLine)

    override fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int) = when (mode) {
        MotorMode.FORWARD -> drive.run(motor, 1, sourceLine)
        MotorMode.BACKWARD -> drive.run(motor, -1, sourceLine)
        MotorMode.BRAKE -> brake(motor, sourceLine)
        MotorMode.FLOAT -> calls.on(HubNative.MOTOR_STOP, motor, sourceLine)
    }

    override fun brake(motor: MotorPort, sourceLine: Int) = calls.on(HubNative.MOTOR_BRAKE, motor, sourceLine)

    override fun turnMotor(motor: MotorPort, angle: NumberValue, waits: Boolean, sourceLine: Int) {
        val degrees = times(angle, 1)
        val noWait = if (waits) 0 else 1
        calls.on(HubNative.MOTOR_RUN_ANGLE, motor, sourceLine, HubFigures.TURNING_SPEED, degrees, noWait)
        remember(motor)
    }

    override fun isTurning(motor: MotorPort): Boolean =
        hub.motor(HubPort.of(motor))?.let { it.commands == turns[motor] && !it.isDone } == true

    override fun resetMotor(motor: MotorPort, sourceLine: Int) =
        calls.on(HubNative.MOTOR_RESET_ANGLE, motor, sourceLine, 0)

    override fun beep(sourceLine: Int) = tone(HubFigures.BEEP_HERTZ, HubFigures.BEEP_MILLISECONDS, sourceLine)

    override fun buzz(sourceLine: Int) = tone(HubFigures.BUZZ_HERTZ, HubFigures.BUZZ_MILLISECONDS, sourceLine)

    override fun playTone(hertz: Int, hundredths: Int, sourceLine: Int) =
        tone(hertz, hundredths * MILLISECONDS_PER_HUNDREDTH, sourceLine)

    /** A hub without a loudspeaker has its light on meanwhile. */
    private fun tone(hertz: Int, milliseconds: Int, sourceLine: Int) {
        outputMilliseconds = milliseconds
        isBlinking = !model.hasSpeaker
        if (model.hasSpeaker) {
            calls.of(HubNative.SPEAKER_BEEP, sourceLine, hertz, milliseconds)
        } else {
            calls.of(HubNative.LIGHT_ON, sourceLine, HubColor.WHITE.ordinal)
        }
    }

    override fun endTone(sourceLine: Int) {
        if (isBlinking) calls.of(HubNative.LIGHT_OFF, sourceLine)
        isBlinking = false
    }

    override fun show(value: NumberValue, sourceLine: Int) {
        val text = when (value) {
            is NumberValue.Whole -> "${value.value}"
            is NumberValue.Decimal -> decimalText(value.decimal)
        }
        print(text, sourceLine)
        val whole = (value as? NumberValue.Whole)?.value ?: value.decimal.toInt()
        if (model.hasMatrix) calls.of(HubNative.DISPLAY_NUMBER, sourceLine, whole)
        if (model.hasScreen) calls.make(HubCall.of(HubNative.SCREEN_PRINT, text), sourceLine)
    }

    override fun showText(text: String, sourceLine: Int) {
        outputMilliseconds = 0
        print(text, sourceLine)
        if (model.hasScreen) calls.make(HubCall.of(HubNative.SCREEN_PRINT, text), sourceLine)
        if (!model.hasMatrix) return
        if (text.length == 1) return calls.make(HubCall.of(HubNative.DISPLAY_CHAR, text), sourceLine)
        calls.make(HubCall.of(HubNative.DISPLAY_TEXT, text), sourceLine)
        outputMilliseconds = text.length * HubFigures.LETTER_MILLISECONDS
    }

    override fun showColour(colour: Int, sourceLine: Int) = print("Color.${colourName(colour)}", sourceLine)

    override fun clearScreen(sourceLine: Int) {
        if (model.hasMatrix) calls.of(HubNative.DISPLAY_OFF, sourceLine)
        if (model.hasScreen) calls.of(HubNative.SCREEN_CLEAR, sourceLine)
    }

    private fun print(text: String, sourceLine: Int) = calls.make(HubCall.of(HubNative.PRINT, text), sourceLine)

    private fun remember(motor: MotorPort) {
        turns[motor] = hub.motor(HubPort.of(motor))?.commands ?: 0
    }

    private fun times(value: NumberValue, factor: Int): Int = when (value) {
        is NumberValue.Whole -> short(value.value.toLong() * factor, messages)
        is NumberValue.Decimal -> short(roundAsPython(value.decimal.toDouble() * factor), messages)
    }

    private fun sign(direction: MoveDirection) = if (direction == MoveDirection.FORWARD) 1 else -1

    /** A turn to the right is positive. */
    private fun sign(direction: TurnDirection) = if (direction == TurnDirection.RIGHT) 1 else -1

    private companion object {
        const val MILLISECONDS_PER_HUNDREDTH = 10
        const val THOUSANDTHS = 1_000
        const val NO_BUTTON = -1
    }
}
