package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.nxt.display.BitBlt
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Picture
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection

/** A robot with an NXT. Makes the calls of the leJOS NXJ methods of a translation, in the same order. */
internal class NxtDevice private constructor(
    private val nxt: Nxt,
    private val robot: RobotTarget.Nxt,
    private val sensors: NxtSensors,
) : RobotDevice,
    RobotSenses by sensors {
    private val motors = NxtMotors(nxt)
    private val pilot = NxtPilot(robot, motors)
    private var lineOfSetUp: (line: Int?) -> Unit = {}

    constructor(nxt: Nxt, robot: RobotTarget.Nxt) : this(nxt, robot, NxtSensors(nxt))

    override val milliseconds: Long get() = nxt.milliseconds

    override val isDriving: Boolean get() = pilot.isMoving

    override val isPenMoving: Boolean get() = robot.pen?.let(motors::isMoving) ?: false

    override val longestTone: Int get() = Int.MAX_VALUE / MILLISECONDS_PER_HUNDREDTH

    override fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit) {
        lineOfSetUp = at
        sensors.begin(ports)
    }

    override val collectsLists: Boolean get() = true

    override val isSetUp: Boolean get() = sensors.goOn(lineOfSetUp)

    override fun startMoving(direction: MoveDirection, sourceLine: Int) {
        val isForward = direction == MoveDirection.FORWARD
        pilot.run(isForward, isForward, sourceLine)
    }

    override fun startTurning(direction: TurnDirection, sourceLine: Int) {
        val isLeft = direction == TurnDirection.LEFT
        pilot.run(leftForward = !isLeft, rightForward = isLeft, sourceLine)
    }

    override fun stopDriving(sourceLine: Int) = pilot.stop(sourceLine)

    override fun drive(direction: MoveDirection, distance: NumberValue, sourceLine: Int): Int {
        pilot.travel(if (direction == MoveDirection.FORWARD) distance.decimal else -distance.decimal, sourceLine)
        return 0
    }

    override fun turn(direction: TurnDirection, angle: NumberValue, sourceLine: Int): Int {
        pilot.rotate(if (direction == TurnDirection.LEFT) angle.decimal else -angle.decimal, sourceLine)
        return 0
    }

    override fun endDrive(sourceLine: Int) = pilot.cutShort(sourceLine)

    override fun startPen(position: PenPosition, sourceLine: Int): Int {
        val degrees = if (position == PenPosition.DOWN) NxtConstants.PEN_DEGREES else 0
        robot.pen?.let { motors.rotateTo(it, degrees, sourceLine) }
        return 0
    }

    override fun stopPen(sourceLine: Int) {
        if (isPenMoving) robot.pen?.let { motors.stop(it, sourceLine) }
    }

    override fun setPower(side: PowerSide, power: Int, sourceLine: Int) {
        if (side != PowerSide.RIGHT) setPower(robot.left, power, sourceLine)
        if (side != PowerSide.LEFT) setPower(robot.right, power, sourceLine)
    }

    override fun setPower(motor: MotorPort, power: Int, sourceLine: Int) =
        motors.setSpeed(motor, NxtConstants.speedOf(power), sourceLine)

    override fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int) = when (mode) {
        MotorMode.FORWARD -> motors.run(motor, isForward = true, sourceLine)
        MotorMode.BACKWARD -> motors.run(motor, isForward = false, sourceLine)
        MotorMode.BRAKE -> motors.stop(motor, sourceLine)
        MotorMode.FLOAT -> motors.roll(motor, sourceLine)
    }

    override fun brake(motor: MotorPort, sourceLine: Int) = motors.stop(motor, sourceLine)

    override fun turnMotor(motor: MotorPort, angle: NumberValue, waits: Boolean, sourceLine: Int) {
        val degrees = if (angle is NumberValue.Whole) angle.value else roundToWhole(angle.decimal)
        motors.rotateTo(motor, motors.position(motor) + degrees, sourceLine)
    }

    override fun isTurning(motor: MotorPort): Boolean = motors.isMoving(motor)

    override fun resetMotor(motor: MotorPort, sourceLine: Int) = motors.reset(motor, sourceLine)

    override fun beep(sourceLine: Int) = play(NxtConstants.BEEP_FREQUENCY, NxtConstants.BEEP_MILLISECONDS, sourceLine)

    override fun buzz(sourceLine: Int) = play(NxtConstants.BUZZ_FREQUENCY, NxtConstants.BUZZ_MILLISECONDS, sourceLine)

    override fun playTone(hertz: Int, hundredths: Int, sourceLine: Int) =
        play(hertz, hundredths * MILLISECONDS_PER_HUNDREDTH, sourceLine)

    /** `Sound.playTone(hertz, milliseconds)`. */
    private fun play(hertz: Int, milliseconds: Int, sourceLine: Int) {
        nxt.call(NxtCall.of(NxtNative.PLAY_FREQ, hertz, milliseconds, NxtConstants.VOLUME), sourceLine)
    }

    override fun show(value: NumberValue, sourceLine: Int) = showText(nxtText(value), sourceLine)

    /** `LCD.clear(0)` and `LCD.drawString(text, 0, 0)`. */
    override fun showText(text: String, sourceLine: Int) {
        val display = Picture(nxt.displayMemory, DisplaySize.WIDTH, DisplaySize.HEIGHT)
        nxt.bitBlt(display, BitBlt(0, 0, 0, 0, DisplaySize.WIDTH, ROW_HEIGHT, CLEAR), sourceLine)
        nxt.call(NxtCall.drawString(text, column = 0, row = 0), sourceLine)
    }

    override fun showColour(colour: Int, sourceLine: Int) = showText(colourName(colour), sourceLine)

    override fun clearScreen(sourceLine: Int) {
        nxt.call(NxtCall(NxtNative.CLEAR), sourceLine)
    }

    private companion object {
        const val MILLISECONDS_PER_HUNDREDTH = 10
        const val ROW_HEIGHT = 8

        /** The operation of a [BitBlt] that clears. */
        const val CLEAR = 0
    }
}
