package robotran.nxt.natives

import robotran.nxt.bluetooth.LinkMedium
import robotran.nxt.display.Drawing
import robotran.nxt.hardware.MotorPorts
import robotran.nxt.hardware.SensorPort
import robotran.nxt.hardware.SensorPower
import robotran.nxt.hardware.SensorType
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative

/** Does what the calls of a program say. */
internal class CallPerformer(private val hardware: NxtHardware) {
    /** Returns the result, 0 if the call has none; null if its arguments are wrong, so that nothing happens. */
    fun perform(call: NxtCall): Int? {
        if (call.numbers.size < call.native.parameters) return null
        return when (call.native) {
            NxtNative.CONTROL_MOTOR, NxtNative.RESET_TACHO_COUNT, NxtNative.REGULATE, NxtNative.REGULATOR_SPEED,
            NxtNative.REGULATOR_ACCELERATION, NxtNative.REGULATOR_ROLL, NxtNative.REGULATOR_SUSPEND,
            NxtNative.REGULATOR_STALL,
            -> {
                if (call.numbers[0] in 0..<MotorPorts.PORTS) performOnMotor(call, call.numbers[0]) else null
            }

            NxtNative.SET_POWER_TYPE, NxtNative.SET_SENSOR_PIN_MODE, NxtNative.SET_SENSOR_PIN, NxtNative.SET_TYPE,
            NxtNative.I2C_ENABLE, NxtNative.I2C_DISABLE, NxtNative.I2C_START,
            -> {
                hardware.sensors.getOrNull(call.numbers[0])?.let { performOnSensor(call, it) }
            }

            NxtNative.DRAW_STRING, NxtNative.DRAW_INT, NxtNative.CLEAR, NxtNative.BIT_BLT, NxtNative.ASYNC_REFRESH,
            NxtNative.SET_AUTO_REFRESH_PERIOD, NxtNative.SET_CONTRAST,
            -> {
                performOnDisplay(call)
            }

            NxtNative.PLAY_FREQ -> done { hardware.speaker.play(call.numbers[0], call.numbers[1], call.numbers[2]) }

            NxtNative.PLAY_QUEUED_SAMPLE -> {
                call.bytes?.let { hardware.speaker.playSamples(it, call.numbers[0], call.numbers[1]) }
            }

            NxtNative.SHUT_DOWN -> done { hardware.isToShutDown = true }

            NxtNative.OPEN, NxtNative.LISTEN, NxtNative.WRITE, NxtNative.CLOSE, NxtNative.OPEN_CABLE,
            NxtNative.LISTEN_CABLE,
            -> {
                performOnRadio(call)
            }

            NxtNative.FLASH_WRITE_PAGE -> {
                call.bytes?.let { if (hardware.flash.writePage(call.numbers[0], it)) 0 else -1 }
            }

            NxtNative.EXIT, NxtNative.EXCEPTION, NxtNative.CONSOLE_LINE -> 0
        }
    }

    private fun performOnMotor(call: NxtCall, port: Int): Int? {
        val regulator = hardware.regulators[port]
        val n = call.numbers
        return when (call.native) {
            NxtNative.CONTROL_MOTOR -> done { hardware.motors.control(port, n[1], brakes = n[2] != 0) }

            NxtNative.RESET_TACHO_COUNT -> done {
                regulator.countReset()
                hardware.motors.resetTachoCount(port)
            }

            NxtNative.REGULATE -> bit(regulator.start(call.speed, n[2], limit = n[3], hold = n[4] != 0))
            NxtNative.REGULATOR_SPEED -> done { regulator.setSpeed(call.speed) }
            NxtNative.REGULATOR_ACCELERATION -> done { regulator.setAcceleration(n[1]) }
            NxtNative.REGULATOR_ROLL -> done { regulator.roll() }
            NxtNative.REGULATOR_SUSPEND -> bit(regulator.suspend())
            NxtNative.REGULATOR_STALL -> done { regulator.setStallThreshold(n[1], n[2]) }
            else -> null
        }
    }

    private fun performOnSensor(call: NxtCall, port: SensorPort): Int? {
        val n = call.numbers
        return when (call.native) {
            NxtNative.SET_POWER_TYPE -> {
                if (n[1] in SensorPower.NONE..SensorPower.NINE_VOLTS) done { port.setPower(n[1]) } else null
            }

            NxtNative.SET_SENSOR_PIN_MODE -> if (n[1] in 0..<SensorPort.PINS) 0 else null

            NxtNative.SET_SENSOR_PIN -> {
                if (n[1] in 0..<SensorPort.PINS) done { port.setPin(n[1], high = n[2] != 0) } else null
            }

            NxtNative.SET_TYPE -> if (SensorType.isKnown(n[1])) done { port.setType(n[1]) } else null
            NxtNative.I2C_ENABLE -> done { port.i2c.enable(n[1]) }
            NxtNative.I2C_DISABLE -> done { port.i2c.disable() }
            NxtNative.I2C_START -> port.i2c.start(n[1], call.bytes ?: NO_BYTES, readLength = n[2])
            else -> null
        }
    }

    private fun performOnDisplay(call: NxtCall): Int? {
        val n = call.numbers
        val display = hardware.display
        return when (call.native) {
            NxtNative.DRAW_STRING -> call.text?.let { text ->
                done { Drawing.drawString(display.memory, text, n[0], n[1], inverted = n[2] != 0) }
            }

            NxtNative.DRAW_INT -> done { Drawing.drawInt(display.memory, n[0], n[1], n[2], n[3]) }
            NxtNative.CLEAR -> done { Drawing.clear(display.memory) }
            NxtNative.ASYNC_REFRESH -> done { display.refresh() }
            NxtNative.SET_AUTO_REFRESH_PERIOD -> display.setAutoRefreshPeriod(n[0])
            NxtNative.SET_CONTRAST -> done { display.setContrast(n[0]) }

            // A picture is no number: see VirtualNxt.bitBlt.
            else -> null
        }
    }

    private fun performOnRadio(call: NxtCall): Int? {
        val radio = hardware.radio
        return when (call.native) {
            NxtNative.OPEN -> call.text?.let { radio.open(it) }
            NxtNative.LISTEN -> radio.listen()
            NxtNative.OPEN_CABLE -> call.text?.let { radio.open(it, LinkMedium.RS485) }
            NxtNative.LISTEN_CABLE -> radio.listen(LinkMedium.RS485)
            NxtNative.WRITE -> call.bytes?.let { radio.links.getOrNull(call.numbers[0])?.write(it) ?: -1 }
            NxtNative.CLOSE -> done { radio.links.getOrNull(call.numbers[0])?.close() }
            else -> null
        }
    }

    private inline fun done(action: () -> Unit): Int {
        action()
        return 0
    }

    private fun bit(isSet: Boolean): Int = if (isSet) 1 else 0

    private companion object {
        val NO_BYTES = ByteArray(0)
    }
}
