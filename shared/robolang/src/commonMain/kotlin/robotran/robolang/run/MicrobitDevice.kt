package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.microbit.messages.MicrobitErrorMessages
import robotran.microbit.messages.reason
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative
import robotran.robolang.robot.Durations
import robotran.robolang.robot.MicrobitFigures
import robotran.robolang.robot.MicrobitUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection

/**
 * A robot with a micro:bit on a buggy. Makes the calls of the program's Python, in the same order. Its wheels know no
 * distances, so drives take a time: the wheels get their power, the program waits, the wheels get none.
 */
internal class MicrobitDevice(
    private val board: Microbit,
    private val robot: RobotTarget.Microbit,
    uses: MicrobitUses,
    private val durations: Durations,
    private val messages: MicrobitErrorMessages,
) : RobotDevice,
    RobotSenses by MicrobitSenses(board, robot, uses) {
    private val buggy = robot.buggy

    /** Which way the wheels turn, 1, 0 or -1, and with which power. */
    private var leftWay = 0
    private var rightWay = 0
    private var leftPower = MicrobitFigures.FIRST_POWER
    private var rightPower = MicrobitFigures.FIRST_POWER

    override val milliseconds: Long get() = board.milliseconds
    override val collectsLists: Boolean get() = true
    override val isSetUp: Boolean get() = true
    override val isDriving: Boolean get() = false
    override val isPenMoving: Boolean get() = false
    override val longestTone: Int get() = Int.MAX_VALUE / MILLISECONDS_PER_HUNDREDTH

    /** The board makes buggy and servo ready itself, see [Microbit]. */
    override fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit) = at(null)

    override fun startMoving(direction: MoveDirection, sourceLine: Int) = sign(direction).let { go(it, it, sourceLine) }

    override fun startTurning(direction: TurnDirection, sourceLine: Int) =
        sign(direction).let { go(it, -it, sourceLine) }

    override fun stopDriving(sourceLine: Int) = go(0, 0, sourceLine)

    override fun drive(direction: MoveDirection, distance: NumberValue, sourceLine: Int): Int {
        val sign = sign(direction) * sign(distance)
        go(sign, sign, sourceLine)
        return durations.ofMove(distance)
    }

    override fun turn(direction: TurnDirection, angle: NumberValue, sourceLine: Int): Int {
        val sign = sign(direction) * sign(angle)
        go(sign, -sign, sourceLine)
        return durations.ofTurn(angle)
    }

    override fun endDrive(sourceLine: Int) = stopDriving(sourceLine)

    override fun startPen(position: PenPosition, sourceLine: Int): Int {
        val servo = buggy.pen?.takeIf { robot.pen != null } ?: return 0
        val isDown = position == PenPosition.DOWN
        make(
            servo.turnTo(if (isDown) MicrobitFigures.PEN_DOWN_DEGREES else MicrobitFigures.PEN_UP_DEGREES),
            sourceLine,
        )
        return MicrobitFigures.PEN_MILLISECONDS
    }

    override fun stopPen(sourceLine: Int) = Unit

    override fun setPower(side: PowerSide, power: Int, sourceLine: Int) {
        if (side != PowerSide.RIGHT) leftPower = power
        if (side != PowerSide.LEFT) rightPower = power
        if (leftWay != 0 || rightWay != 0) turnWheels(sourceLine)
    }

    override fun setPower(motor: MotorPort, power: Int, sourceLine: Int) = when (motor) {
        robot.left -> setPower(PowerSide.LEFT, power, sourceLine)
        robot.right -> setPower(PowerSide.RIGHT, power, sourceLine)
        else -> Unit
    }

    /** The motor of the pen turns it down when it runs forward. */
    override fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int) {
        val way = when (mode) {
            MotorMode.FORWARD -> 1
            MotorMode.BACKWARD -> -1
            MotorMode.BRAKE, MotorMode.FLOAT -> 0
        }
        when {
            motor == robot.left -> leftWay = way

            motor == robot.right -> rightWay = way

            else -> {
                if (way != 0) startPen(if (way > 0) PenPosition.DOWN else PenPosition.UP, sourceLine)
                return
            }
        }
        turnWheels(sourceLine)
    }

    override fun brake(motor: MotorPort, sourceLine: Int) = run(motor, MotorMode.BRAKE, sourceLine)

    override fun turnMotor(motor: MotorPort, angle: NumberValue, waits: Boolean, sourceLine: Int) = notOnThisBrick()

    override fun isTurning(motor: MotorPort): Boolean = notOnThisBrick()

    override fun resetMotor(motor: MotorPort, sourceLine: Int) = notOnThisBrick()

    override fun beep(sourceLine: Int) = tone(MicrobitFigures.BEEP_HERTZ, MicrobitFigures.BEEP_MILLISECONDS, sourceLine)

    override fun buzz(sourceLine: Int) = tone(MicrobitFigures.BUZZ_HERTZ, MicrobitFigures.BUZZ_MILLISECONDS, sourceLine)

    override fun playTone(hertz: Int, hundredths: Int, sourceLine: Int) =
        tone(hertz, hundredths * MILLISECONDS_PER_HUNDREDTH, sourceLine)

    override fun show(value: NumberValue, sourceLine: Int) = showText(
        when (value) {
            is NumberValue.Whole -> "${value.value}"
            is NumberValue.Decimal -> decimalText(value.decimal)
        },
        sourceLine,
    )

    override fun showText(text: String, sourceLine: Int) {
        make(MicrobitCall.of(MicrobitNative.PRINT, text), sourceLine)
        val native = if (text.length == 1) MicrobitNative.DISPLAY_SHOW else MicrobitNative.DISPLAY_SCROLL
        make(MicrobitCall.of(native, text), sourceLine)
    }

    override fun showColour(colour: Int, sourceLine: Int) = notOnThisBrick()

    override fun clearScreen(sourceLine: Int) = make(MicrobitCall.of(MicrobitNative.DISPLAY_CLEAR), sourceLine)

    private fun tone(hertz: Int, milliseconds: Int, sourceLine: Int) {
        if (robot.playsTones) make(MicrobitCall.of(MicrobitNative.MUSIC_PITCH, hertz, milliseconds), sourceLine)
    }

    /** Drives the robot ahead with both 1, whichever way its motors turn for that. */
    private fun go(left: Int, right: Int, sourceLine: Int) {
        val sign = if (robot.isReversed) -1 else 1
        leftWay = sign * left
        rightWay = sign * right
        turnWheels(sourceLine)
    }

    private fun turnWheels(sourceLine: Int) {
        val left = leftWay * MicrobitFigures.percentOf(leftPower, robot.trim.left)
        val right = rightWay * MicrobitFigures.percentOf(rightPower, robot.trim.right)
        for (call in buggy.wheels.calls(left, right)) make(call, sourceLine)
    }

    private fun make(call: MicrobitCall, sourceLine: Int) {
        val error = board.call(call, sourceLine) ?: return
        fail(messages.reason(error))
    }

    private fun sign(direction: MoveDirection) = if (direction == MoveDirection.FORWARD) 1 else -1

    /** The left wheel drives ahead to turn to the right. */
    private fun sign(direction: TurnDirection) = if (direction == TurnDirection.RIGHT) 1 else -1

    private fun sign(value: NumberValue) = if (value.isNegative) -1 else 1

    private companion object {
        const val MILLISECONDS_PER_HUNDREDTH = 10
    }
}
