package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorRequest
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.BrickButton

/** Reads the sensors with the same ROM calls as the josx methods named below. */
internal class RcxSenses(private val rom: Rom) : RobotSenses {
    /** `Sensor.S1.readBooleanValue()`. */
    override fun isPressed(port: Int): Boolean = rom.readSensor(port - 1, SensorRequest.BOOLEAN) != 0

    override fun light(port: Int): Int = value(port)

    /** `Sensor.S1.readValue()`. */
    override fun value(port: Int): Int = rom.readSensor(port - 1, SensorRequest.CANONICAL)

    /** `Button.RUN.isPressed()`. */
    override fun isHeld(button: BrickButton, sourceLine: Int): Boolean {
        rom.call(RomCall(RomAddress.READ_BUTTONS, listOf(RomCode.BUTTONS, RobotConstants.RESULT_ADDRESS)), sourceLine)
        val bit = BITS.getValue(checkNotNull(button.among(BITS.keys)))
        return rom.memory.readShort(RobotConstants.RESULT_ADDRESS) and bit != 0
    }

    /** `Battery.getVoltage()`. */
    override fun batteryVolts(sourceLine: Int): Float {
        rom.call(
            RomCall(RomAddress.READ_POWER_STATUS, listOf(RomCode.BATTERY, RobotConstants.RESULT_ADDRESS)),
            sourceLine,
        )
        val measured = rom.memory.readShort(RobotConstants.RESULT_ADDRESS)
        return measured * RobotConstants.BATTERY_FACTOR / RobotConstants.BATTERY_DIVISOR / MILLI
    }

    override fun measureDistance(port: Int, sourceLine: Int) = notOnThisBrick()

    override fun hasDistance(port: Int): Boolean = notOnThisBrick()

    override fun distance(port: Int): Int = notOnThisBrick()

    override fun loudness(port: Int): Int = notOnThisBrick()

    override fun colour(port: Int): Int = notOnThisBrick()

    override fun turned(motor: MotorPort): Int = notOnThisBrick()

    private companion object {
        const val MILLI = 1000f

        /** Source: leJOS `Button.java`. */
        val BITS = mapOf(BrickButton.RUN to 1, BrickButton.VIEW to 2, BrickButton.PRGM to 4)
    }
}

/** Sets up the sensors of an RCX before the first statement. */
internal class RcxSensorSetup(private val rom: Rom) {
    fun setUp(ports: SensorPorts, at: (line: Int?) -> Unit) {
        for (bumper in ports.bumpers) {
            at(bumper.line)
            rom.setSensorTypeAndMode(bumper.port - 1, SensorCode.TYPE_TOUCH, SensorCode.MODE_BOOLEAN)
        }
        if (ports.usesLight) {
            at(ports.lightLine)
            val sensor = SensorCode.FIRST_PORT + ports.lightPort - 1
            rom.call(RomCall(RomAddress.ACTIVATE_SENSOR, listOf(sensor)), ports.lightLine)
        }
        at(null)
    }
}
