package robotran.microbit.hardware

import robotran.microbit.buggy.BridgePins
import robotran.microbit.buggy.BridgeWheels
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.I2cServo
import robotran.microbit.buggy.I2cWheels
import robotran.microbit.buggy.PinServo
import robotran.microbit.buggy.ServoPulse
import robotran.microbit.buggy.ServoWheels
import robotran.microbit.buggy.WheelSide
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitError
import robotran.microbit.program.MicrobitNative

/** The electronics of a buggy: reads back what a program writes, and keeps it until it gets something else. */
internal class BuggyChip(private val buggy: Buggy) {
    private val pins = mutableMapOf<Int, Int>()
    private val i2c = buggy.wheels as? I2cWheels

    /** Percent of full power of the wheels, -100..100. */
    var left = 0
        private set
    var right = 0
        private set

    /** Where the servo of the pen stands, degrees; null before it has been told. */
    var servo: Int? = null
        private set

    /** Writes bytes to an address, the first of [numbers]. */
    fun write(numbers: IntArray): MicrobitError? {
        val bytes = numbers.drop(1)
        if (bytes.any { it !in BYTES }) return MicrobitError.INVALID_ARGUMENT
        val pen = buggy.pen as? I2cServo
        val answers = setOfNotNull(i2c?.address, pen?.address)
        if (numbers[0] !in answers) return MicrobitError.NO_DEVICE
        for (frame in i2c?.frames.orEmpty()) {
            if (!frame.matches(bytes)) continue
            frame.percent(WheelSide.LEFT, bytes)?.let { left = it }
            frame.percent(WheelSide.RIGHT, bytes)?.let { right = it }
        }
        if (pen?.frame?.matches(bytes) == true) pen.frame.angle(bytes)?.let { servo = it }
        return null
    }

    /** Puts pulses of [value], 0..1023, on a pin. */
    fun setPin(pin: Int, value: Int): MicrobitError? {
        if (pin !in PINS || value !in 0..BridgePins.FULL) return MicrobitError.INVALID_ARGUMENT
        pins[pin] = value
        when (val wheels = buggy.wheels) {
            is I2cWheels -> Unit

            is ServoWheels -> {
                left = ServoPulse.speedOf(pinOf(wheels.left))
                right = -ServoPulse.speedOf(pinOf(wheels.right))
            }

            is BridgeWheels -> {
                left = percentOf(wheels.left)
                right = percentOf(wheels.right)
            }
        }
        if ((buggy.pen as? PinServo)?.pin == pin) ServoPulse.angleOf(value)?.let { servo = it }
        return null
    }

    /** Whether [call] stops both wheels, or is a part of that. */
    fun isStop(call: MicrobitCall): Boolean = buggy.stopCalls.any { it.toString() == call.toString() }

    /** Whether [call] turns the servo of the pen. */
    fun isServo(call: MicrobitCall): Boolean = when (val pen = buggy.pen) {
        null -> false
        is I2cServo -> call.native == MicrobitNative.I2C_WRITE && pen.frame.matches(call.numbers.drop(1))
        is PinServo -> call.native == MicrobitNative.PIN_ANALOG && call.numbers[0] == pen.pin
    }

    /** Both pins high brake; nobody writes that. */
    private fun percentOf(motor: BridgePins): Int = share(pinOf(motor.ahead)) - share(pinOf(motor.back))

    private fun share(value: Int) = (value * ALL + BridgePins.FULL / 2) / BridgePins.FULL

    private fun pinOf(pin: Int) = pins[pin] ?: 0

    private companion object {
        const val ALL = 100
        val BYTES = 0..255
        val PINS = 0..20
    }
}
