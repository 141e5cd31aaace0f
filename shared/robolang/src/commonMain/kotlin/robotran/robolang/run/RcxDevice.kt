package robotran.robolang.run

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.controls.romCode
import robotran.rcxrom.display.TextLcd
import robotran.rcxrom.program.Rom
import robotran.robolang.robot.Durations
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.SensorPorts
import robotran.robolang.robot.thirdMotor
import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.PowerSide
import robotran.robolang.syntax.TurnDirection

/**
 * A robot with an RCX. Converts commands to ROM calls: the same ones in the same order as the josx methods named below.
 * There `Motor.A` stands for the motor of the left wheel, `Motor.C` for the right one, `Motor.B` for the pen. Like josx,
 * it remembers the last command of each motor. Its motors know no distances, so drives take a time.
 */
internal class RcxDevice(private val rom: Rom, private val robot: RobotTarget.Rcx, private val durations: Durations) :
    RobotDevice,
    RobotSenses by RcxSenses(rom) {
    private val sensors = RcxSensorSetup(rom)
    private val modes = MotorPort.entries.associateWith { MotorMode.FLOAT }.toMutableMap()
    private val powers = MotorPort.entries.associateWith { RobotConstants.DRIVING_POWER }.toMutableMap()

    override val milliseconds: Long get() = rom.milliseconds

    override val isDriving: Boolean get() = false

    override val isPenMoving: Boolean get() = false

    override val longestTone: Int get() = RobotConstants.LONGEST_TONE

    override val collectsLists: Boolean get() = false

    override val isSetUp: Boolean get() = true

    override fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit) = sensors.setUp(ports, at)

    /** `Motor.A` and `Motor.C`, `forward()` or `backward()`. */
    override fun startMoving(direction: MoveDirection, sourceLine: Int) {
        val mode = when (direction) {
            MoveDirection.FORWARD -> MotorMode.FORWARD
            MoveDirection.BACKWARD -> MotorMode.BACKWARD
        }
        drive(left = mode, right = mode, sourceLine)
    }

    /** `Motor.A.backward()` and `Motor.C.forward()`, or the other way round. */
    override fun startTurning(direction: TurnDirection, sourceLine: Int) {
        when (direction) {
            TurnDirection.LEFT -> drive(left = MotorMode.BACKWARD, right = MotorMode.FORWARD, sourceLine)
            TurnDirection.RIGHT -> drive(left = MotorMode.FORWARD, right = MotorMode.BACKWARD, sourceLine)
        }
    }

    /** `Motor.A.stop()` and `Motor.C.stop()`. */
    override fun stopDriving(sourceLine: Int) {
        brake(robot.left, sourceLine)
        brake(robot.right, sourceLine)
    }

    override fun drive(direction: MoveDirection, distance: NumberValue, sourceLine: Int): Int {
        val milliseconds = durations.ofMove(distance)
        startMoving(if (distance.isNegative) direction.opposite else direction, sourceLine)
        return milliseconds
    }

    override fun turn(direction: TurnDirection, angle: NumberValue, sourceLine: Int): Int {
        val milliseconds = durations.ofTurn(angle)
        startTurning(if (angle.isNegative) direction.opposite else direction, sourceLine)
        return milliseconds
    }

    override fun endDrive(sourceLine: Int) = stopDriving(sourceLine)

    /** `Motor.B.forward()` or `backward()`. */
    override fun startPen(position: PenPosition, sourceLine: Int): Int {
        when (position) {
            PenPosition.DOWN -> run(robot.thirdMotor, MotorMode.FORWARD, sourceLine)
            PenPosition.UP -> run(robot.thirdMotor, MotorMode.BACKWARD, sourceLine)
        }
        return RobotConstants.PEN_MILLISECONDS
    }

    /** `Motor.B.stop()`. */
    override fun stopPen(sourceLine: Int) {
        brake(robot.thirdMotor, sourceLine)
    }

    /** `Sound.beep()`. */
    override fun beep(sourceLine: Int) {
        call(sourceLine, RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, RobotConstants.SOUND_BEEP)
    }

    /** `LCD.setNumber(LCDConstants.LCD_SIGNED, digits, point)` and `LCD.refresh()`. */
    override fun show(value: NumberValue, sourceLine: Int) {
        val number = lcdNumber(value)
        val point = RomCode.LCD_POINT_NONE + number.decimals
        call(sourceLine, RomAddress.SET_LCD_NUMBER, RomCode.LCD_SIGNED, number.digits, point)
        call(sourceLine, RomAddress.REFRESH_LCD)
    }

    /** `Sound.buzz()`. */
    override fun buzz(sourceLine: Int) {
        call(sourceLine, RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, RobotConstants.SOUND_BUZZ)
    }

    /** `Sound.playTone(hertz, hundredths)`. */
    override fun playTone(hertz: Int, hundredths: Int, sourceLine: Int) {
        call(sourceLine, RomAddress.PLAY_TONE, RomCode.TONE, hertz, hundredths)
    }

    /** `TextLCD.print(text)` and `LCD.refresh()`. */
    override fun showText(text: String, sourceLine: Int) {
        TextLcd.print(text, rom.memory)
        call(sourceLine, RomAddress.REFRESH_LCD)
    }

    /** `LCD.clear()` and `LCD.refresh()`. */
    override fun clearScreen(sourceLine: Int) {
        call(sourceLine, RomAddress.CLEAR_LCD)
        call(sourceLine, RomAddress.REFRESH_LCD)
    }

    /** `Motor.A.setPower(power)`, and `Motor.C` for the right side, `A` before `C` for both. */
    override fun setPower(side: PowerSide, power: Int, sourceLine: Int) {
        if (side != PowerSide.RIGHT) setPower(robot.left, power, sourceLine)
        if (side != PowerSide.LEFT) setPower(robot.right, power, sourceLine)
    }

    /** `Motor.A.setPower(power)` and so on, which acts at once. */
    override fun setPower(motor: MotorPort, power: Int, sourceLine: Int) {
        powers[motor] = power
        control(motor, modes.getValue(motor), power, sourceLine)
    }

    /** `Motor.A.forward()`, `backward()` or `flt()` and so on. */
    override fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int) {
        modes[motor] = mode
        control(motor, mode, powers.getValue(motor), sourceLine)
    }

    /** `Motor.A.stop()` and so on. */
    override fun brake(motor: MotorPort, sourceLine: Int) {
        modes[motor] = MotorMode.BRAKE
        control(motor, MotorMode.BRAKE, RobotConstants.BRAKING_POWER, sourceLine)
    }

    override fun turnMotor(motor: MotorPort, angle: NumberValue, waits: Boolean, sourceLine: Int) = notOnThisBrick()

    override fun isTurning(motor: MotorPort): Boolean = notOnThisBrick()

    override fun resetMotor(motor: MotorPort, sourceLine: Int) = notOnThisBrick()

    override fun showColour(colour: Int, sourceLine: Int) = notOnThisBrick()

    private fun drive(left: MotorMode, right: MotorMode, sourceLine: Int) {
        run(robot.left, onWheel(left), sourceLine)
        run(robot.right, onWheel(right), sourceLine)
    }

    private fun onWheel(mode: MotorMode): MotorMode = when {
        !robot.isReversed -> mode
        mode == MotorMode.FORWARD -> MotorMode.BACKWARD
        mode == MotorMode.BACKWARD -> MotorMode.FORWARD
        else -> mode
    }

    private fun control(motor: MotorPort, mode: MotorMode, power: Int, sourceLine: Int) {
        call(sourceLine, RomAddress.CONTROL_MOTOR, motor.romCode, mode.code, power)
    }

    private fun call(sourceLine: Int, address: Int, vararg arguments: Int) {
        rom.call(RomCall(address, arguments.map { it and UNSIGNED_SHORT }), sourceLine)
    }

    private companion object {
        const val UNSIGNED_SHORT = 0xFFFF
    }
}

/** The checker lets no program for an RCX get here. */
internal fun notOnThisBrick(): Nothing = error("This brick has nothing like that.")

private val MoveDirection.opposite: MoveDirection
    get() = if (this == MoveDirection.FORWARD) MoveDirection.BACKWARD else MoveDirection.FORWARD

private val TurnDirection.opposite: TurnDirection
    get() = if (this == TurnDirection.LEFT) TurnDirection.RIGHT else TurnDirection.LEFT
