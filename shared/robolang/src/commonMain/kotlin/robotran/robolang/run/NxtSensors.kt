package robotran.robolang.run

import robotran.brick.controls.MotorPort
import robotran.nxt.hardware.I2cMode
import robotran.nxt.hardware.SensorPower
import robotran.nxt.hardware.SensorType
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Sense

/** Sets up and reads the sensors of an NXT with the calls of leJOS NXJ's classes. */
internal class NxtSensors(private val nxt: Nxt) : RobotSenses {
    private val sonars = mutableMapOf<Int, NxtSonar>()
    private val toSetUp = ArrayDeque<SensorPorts.NxtUse>()
    private var isBegun = false
    private var isLampNew = false
    private var readyAt = 0L

    fun begin(ports: SensorPorts) {
        toSetUp += ports.nxtSensors
    }

    /** Goes on with setting up the sensors, one after the other; returns whether all are ready. */
    fun goOn(at: (line: Int?) -> Unit): Boolean {
        while (toSetUp.isNotEmpty()) {
            val use = toSetUp.first()
            if (!isBegun) {
                at(use.line)
                begin(use)
                isBegun = true
            }
            if (nxt.milliseconds < readyAt || sonars[use.port]?.goOn() == false) return false
            toSetUp.removeFirst()
            isBegun = false
        }
        at(null)
        if (isLampNew) readyAt = nxt.milliseconds + NxtConstants.LAMP_MILLISECONDS
        isLampNew = false
        return nxt.milliseconds >= readyAt
    }

    private fun begin(use: SensorPorts.NxtUse) {
        when (use.sense) {
            Sense.Light -> {
                setType(use, if (use.isLampOff) SensorType.LIGHT_INACTIVE else SensorType.LIGHT_ACTIVE)
                if (!use.isLampOff) isLampNew = true
            }

            Sense.Loudness -> setType(use, SensorType.SOUND_DB)

            Sense.Colour -> {
                setType(use, SensorType.COLOUR_FULL)
                readyAt = nxt.milliseconds + COLOUR_DELAY
            }

            Sense.Distance -> {
                setType(use, SensorType.LOWSPEED_9V)
                call(use, NxtNative.I2C_ENABLE, I2cMode.LEGO)
                sonars[use.port] = NxtSonar(nxt, use.port - 1).also { it.setUp(use.line) }
            }

            else -> setType(use, SensorType.SWITCH)
        }
    }

    /** `SensorPort.setType`. */
    private fun setType(use: SensorPorts.NxtUse, type: Int) {
        call(use, NxtNative.SET_TYPE, type)
        val power = if (type == SensorType.LOWSPEED_9V) SensorPower.NINE_VOLTS else SensorPower.NONE
        call(use, NxtNative.SET_POWER_TYPE, power)
        if (SensorType.isColour(type)) return
        call(use, NxtNative.SET_SENSOR_PIN_MODE, FIRST_PIN, OUTPUT)
        call(use, NxtNative.SET_SENSOR_PIN_MODE, SECOND_PIN, OUTPUT)
        val isActive = type == SensorType.LIGHT_ACTIVE || type == SensorType.SOUND_DB
        call(use, NxtNative.SET_SENSOR_PIN, FIRST_PIN, if (isActive) 1 else 0)
        call(use, NxtNative.SET_SENSOR_PIN, SECOND_PIN, 0)
    }

    private fun call(use: SensorPorts.NxtUse, native: NxtNative, vararg numbers: Int) {
        nxt.call(NxtCall.of(native, use.port - 1, *numbers), use.line)
    }

    /** `TouchSensor.isPressed()`. */
    override fun isPressed(port: Int): Boolean = nxt.analog(port - 1) < PRESSED_BELOW

    /** `LightSensor.getLightValue()`. */
    override fun light(port: Int): Int = percent(port)

    /** `SoundSensor.readValue()`. */
    override fun loudness(port: Int): Int = percent(port)

    override fun value(port: Int): Int = nxt.analog(port - 1)

    /** `Button.ENTER.isPressed()`. */
    override fun isHeld(button: BrickButton, sourceLine: Int): Boolean =
        nxt.buttons() and BITS.getValue(checkNotNull(button.among(BITS.keys))) != 0

    /** `Battery.getVoltage()`. */
    override fun batteryVolts(sourceLine: Int): Float = (nxt.batteryStatus() and MILLIVOLTS) * 0.001f

    override fun measureDistance(port: Int, sourceLine: Int) = sonars.getValue(port).measure(sourceLine)

    override fun hasDistance(port: Int): Boolean = sonars.getValue(port).goOn()

    override fun distance(port: Int): Int = sonars.getValue(port).distance

    /** `ColorSensor.getColorID()`. */
    override fun colour(port: Int): Int = nxt.colour(port - 1)?.kind?.code ?: NO_COLOUR

    override fun turned(motor: MotorPort): Int = nxt.tachoCount(motor.ordinal)

    private fun percent(port: Int): Int = (HIGHEST - nxt.analog(port - 1)) * PERCENT / HIGHEST

    private companion object {
        const val FIRST_PIN = 0
        const val SECOND_PIN = 1
        const val OUTPUT = 2
        const val COLOUR_DELAY = 100
        const val PRESSED_BELOW = 600
        const val HIGHEST = 1023
        const val PERCENT = 100
        const val MILLIVOLTS = 0x3FFF
        const val NO_COLOUR = -1
        val BITS = mapOf(BrickButton.ENTER to 1, BrickButton.LEFT to 2, BrickButton.RIGHT to 4, BrickButton.ESCAPE to 8)
    }
}
