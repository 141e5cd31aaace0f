package robotran.robolang.run

import robotran.robolang.syntax.MoveDirection
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.PenPosition
import robotran.robolang.syntax.TurnDirection
import robotran.rom.MotorMode
import robotran.rom.MotorPort
import robotran.rom.Rom
import robotran.rom.RomAddress
import robotran.rom.RomCall
import robotran.rom.RomCode

/** The one place where statements become ROM calls: the same ones, in the same order, as the josx methods named with each. */
internal class RobotCommands(private val rom: Rom) {
    /** `Motor.A` and `Motor.C`, `forward()` or `backward()`. */
    fun startMoving(direction: MoveDirection, sourceLine: Int) {
        val mode = when (direction) {
            MoveDirection.FORWARD -> MotorMode.FORWARD
            MoveDirection.BACKWARD -> MotorMode.BACKWARD
        }
        drive(left = mode, right = mode, sourceLine)
    }

    /** `Motor.A.backward()` and `Motor.C.forward()`, or the other way round. */
    fun startTurning(direction: TurnDirection, sourceLine: Int) {
        when (direction) {
            TurnDirection.LEFT -> drive(left = MotorMode.BACKWARD, right = MotorMode.FORWARD, sourceLine)
            TurnDirection.RIGHT -> drive(left = MotorMode.FORWARD, right = MotorMode.BACKWARD, sourceLine)
        }
    }

    /** `Motor.A.stop()` and `Motor.C.stop()`. */
    fun stopDriving(sourceLine: Int) {
        brake(LEFT_MOTOR, sourceLine)
        brake(RIGHT_MOTOR, sourceLine)
    }

    /** `Motor.B.forward()` or `backward()`. */
    fun startPen(position: PenPosition, sourceLine: Int) {
        when (position) {
            PenPosition.DOWN -> run(PEN_MOTOR, MotorMode.FORWARD, sourceLine)
            PenPosition.UP -> run(PEN_MOTOR, MotorMode.BACKWARD, sourceLine)
        }
    }

    /** `Motor.B.stop()`. */
    fun stopPen(sourceLine: Int) {
        brake(PEN_MOTOR, sourceLine)
    }

    /** `Sound.beep()`. */
    fun beep(sourceLine: Int) {
        call(sourceLine, RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, RobotConstants.SOUND_BEEP)
    }

    /** `LCD.setNumber(LCDConstants.LCD_SIGNED, digits, point)` and `LCD.refresh()`. */
    fun show(value: NumberValue, sourceLine: Int) {
        val number = lcdNumber(value)
        val point = RomCode.LCD_POINT_NONE + number.decimals
        call(sourceLine, RomAddress.SET_LCD_NUMBER, RomCode.LCD_SIGNED, number.digits, point)
        call(sourceLine, RomAddress.REFRESH_LCD)
    }

    private fun drive(left: MotorMode, right: MotorMode, sourceLine: Int) {
        run(LEFT_MOTOR, left, sourceLine)
        run(RIGHT_MOTOR, right, sourceLine)
    }

    private fun run(motor: MotorPort, mode: MotorMode, sourceLine: Int) {
        call(sourceLine, RomAddress.CONTROL_MOTOR, motor.code, mode.code, RobotConstants.DRIVING_POWER)
    }

    private fun brake(motor: MotorPort, sourceLine: Int) {
        call(sourceLine, RomAddress.CONTROL_MOTOR, motor.code, MotorMode.BRAKE.code, RobotConstants.BRAKING_POWER)
    }

    private fun call(sourceLine: Int, address: Int, vararg arguments: Int) {
        rom.call(RomCall(address, arguments.map { it and UNSIGNED_SHORT }), sourceLine)
    }

    private companion object {
        val LEFT_MOTOR = MotorPort.A
        val RIGHT_MOTOR = MotorPort.C
        val PEN_MOTOR = MotorPort.B
        const val UNSIGNED_SHORT = 0xFFFF
    }
}
