package robotran.nxt.messages

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.language.quoted
import robotran.nxt.display.Drawing
import robotran.nxt.display.Font5x7
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.tenths
import robotran.nxt.regulator.MotorRegulator

/** What [call] did, in words. */
internal fun NxtMessages.describe(call: NxtCall, result: Int): String {
    val n = call.numbers
    return when (call.native) {
        NxtNative.CONTROL_MOTOR -> describeMotor(motorPort(n), n[1], isBraking = n[2] != 0)
        NxtNative.RESET_TACHO_COUNT -> resetTachoCount(motorPort(n))
        NxtNative.REGULATE -> describeMove(motorPort(n), call.speed, limit = n[3], isHeld = n[4] != 0)
        NxtNative.REGULATOR_SPEED -> motorSpeed(motorPort(n), sizeOf(call.speed))
        NxtNative.REGULATOR_ACCELERATION -> motorAcceleration(motorPort(n), n[1])
        NxtNative.REGULATOR_ROLL -> rollMotor(motorPort(n))
        NxtNative.REGULATOR_SUSPEND -> regulateNoMore(motorPort(n))
        NxtNative.REGULATOR_STALL -> stallThreshold(motorPort(n), n[1], n[2])
        NxtNative.SET_POWER_TYPE -> sensorPower(n[0] + 1, n[1])
        NxtNative.SET_SENSOR_PIN_MODE -> pinMode(n[0] + 1, n[1], n[2])
        NxtNative.SET_SENSOR_PIN -> pin(n[0] + 1, n[1], isHigh = n[2] != 0)
        NxtNative.SET_TYPE -> sensorType(n[0] + 1, n[1])
        NxtNative.I2C_ENABLE -> i2cReady(n[0] + 1)
        NxtNative.I2C_DISABLE -> i2cOff(n[0] + 1)

        NxtNative.I2C_START -> {
            if (result < 0) i2cRefused(n[0] + 1, result) else i2cMessage(n[0] + 1, call.bytes?.size ?: 0, n[2])
        }

        NxtNative.DRAW_STRING -> describeText(call.text.orEmpty(), n[0], n[1], isInverted = n[2] != 0)
        NxtNative.DRAW_INT -> describeText(Drawing.intText(n[0], n[1]), n[2], n[3], isInverted = false)
        NxtNative.CLEAR -> clearDisplay()
        NxtNative.BIT_BLT -> drawPicture(width = n[6], height = n[7], x = n[4], y = n[5])
        NxtNative.ASYNC_REFRESH -> refreshDisplay()
        NxtNative.SET_AUTO_REFRESH_PERIOD -> refreshEvery(n[0])
        NxtNative.SET_CONTRAST -> contrast(n[0])
        NxtNative.PLAY_FREQ -> tone(n[0], n[1], n[2])
        NxtNative.PLAY_QUEUED_SAMPLE -> samples(result, n[0])
        NxtNative.SHUT_DOWN -> shutDown()

        NxtNative.OPEN, NxtNative.OPEN_CABLE -> {
            if (result < 0) {
                noRobot(quoted(call.text.orEmpty()))
            } else {
                connectTo(quoted(call.text.orEmpty()))
            }
        }

        NxtNative.LISTEN, NxtNative.LISTEN_CABLE -> awaitConnection()
        NxtNative.WRITE -> if (result < 0) notSent(n[0]) else sent(result, n[0])
        NxtNative.CLOSE -> closeLink(n[0])
        NxtNative.EXIT -> exit()
        NxtNative.EXCEPTION -> exception(n[0])
        NxtNative.CONSOLE_LINE -> console(quoted(call.text.orEmpty()))
        NxtNative.FLASH_WRITE_PAGE -> if (result < 0) noPage(n[0]) else writePage(n[0])
    }
}

private fun motorPort(numbers: IntArray) = MotorPort.entries[numbers[0]]

private fun NxtMessages.describeMotor(port: MotorPort, power: Int, isBraking: Boolean): String {
    val strength = power.coerceIn(-HIGHEST_POWER, HIGHEST_POWER)
    val mode = when {
        strength > 0 -> MotorMode.FORWARD
        strength < 0 -> MotorMode.BACKWARD
        isBraking -> MotorMode.BRAKE
        else -> MotorMode.FLOAT
    }
    return motor(port, mode, if (strength < 0) -strength else strength, isBraking)
}

private fun NxtMessages.describeMove(port: MotorPort, speed: Float, limit: Int, isHeld: Boolean): String {
    val isEndless = limit == MotorRegulator.FORWARD || limit == MotorRegulator.BACKWARD
    return when {
        !isEndless -> turnTo(port, sizeOf(speed), limit, isHeld)
        speed == 0f -> stopMotor(port, isHeld)
        else -> turnOn(port, sizeOf(speed), isForward = limit == MotorRegulator.FORWARD)
    }
}

private fun NxtMessages.describeText(text: String, column: Int, row: Int, isInverted: Boolean): String {
    val gaps = text.toList().distinct().filter { it != '\n' && !Font5x7.has(it) }.map { it.toString() }
    return drawText(quoted(text.replace("\n", "\\n")), column, row, isInverted, gaps)
}

private fun sizeOf(speed: Float): String = tenths(if (speed < 0) -speed else speed)

private const val HIGHEST_POWER = 100
