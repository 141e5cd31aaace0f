package robotran.robolang.run

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorRequest

/** Reads the sensors with the same ROM calls as the josx methods named below. */
internal class RobotSenses(private val rom: Rom) {
    private var timerStart = rom.milliseconds

    /** `Sensor.S1.setTypeAndMode(type, mode)` and so on; [port] is 1..3. */
    fun setTypeAndMode(port: Int, type: Int, mode: Int) = rom.setSensorTypeAndMode(port - 1, type, mode)

    /** `Sensor.S2.activate()`. */
    fun activate(port: Int, sourceLine: Int) {
        rom.call(RomCall(RomAddress.ACTIVATE_SENSOR, listOf(SensorCode.FIRST_PORT + port - 1)), sourceLine)
    }

    /** `Sensor.S1.readBooleanValue()`. */
    fun isPressed(port: Int): Boolean = rom.readSensor(port - 1, SensorRequest.BOOLEAN) != 0

    /** `Sensor.S1.readValue()`. */
    fun value(port: Int): Int = rom.readSensor(port - 1, SensorRequest.CANONICAL)

    /** `Button.RUN.isPressed()`; [bit] is the button's. */
    fun isHeld(bit: Int, sourceLine: Int): Boolean {
        rom.call(RomCall(RomAddress.READ_BUTTONS, listOf(RomCode.BUTTONS, RobotConstants.RESULT_ADDRESS)), sourceLine)
        return rom.memory.readShort(RobotConstants.RESULT_ADDRESS) and bit != 0
    }

    /** `Battery.getVoltage()`. */
    fun batteryVolts(sourceLine: Int): Float {
        rom.call(
            RomCall(RomAddress.READ_POWER_STATUS, listOf(RomCode.BATTERY, RobotConstants.RESULT_ADDRESS)),
            sourceLine,
        )
        val measured = rom.memory.readShort(RobotConstants.RESULT_ADDRESS)
        return measured * RobotConstants.BATTERY_FACTOR / RobotConstants.BATTERY_DIVISOR / MILLI
    }

    /** `start = (int) System.currentTimeMillis()`. */
    fun resetTimer() {
        timerStart = rom.milliseconds
    }

    /** `((int) System.currentTimeMillis() - start) / 1000f`. */
    fun timerSeconds(): Float = (rom.milliseconds - timerStart).toInt() / MILLI

    private companion object {
        const val MILLI = 1000f
    }
}
