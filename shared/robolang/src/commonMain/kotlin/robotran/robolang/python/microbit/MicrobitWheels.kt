package robotran.robolang.python.microbit

import robotran.microbit.buggy.BridgePins
import robotran.microbit.buggy.BridgeWheels
import robotran.microbit.buggy.Frame
import robotran.microbit.buggy.FrameByte
import robotran.microbit.buggy.I2cServo
import robotran.microbit.buggy.I2cWheels
import robotran.microbit.buggy.PenServo
import robotran.microbit.buggy.PinServo
import robotran.microbit.buggy.ServoWheels
import robotran.microbit.buggy.WheelSide
import robotran.microbit.buggy.Wheels
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitNative
import robotran.robolang.python.writer.PythonUses

/** Writes how a buggy is told the percents of its wheels, which are in `left` and `right`, and the angle of its servo. */
internal class MicrobitWheels(private val uses: PythonUses) {
    private fun board(name: String): String = uses.import("microbit", name)

    fun pin(number: Int): String = board("pin$number")

    /** The lines that tell [wheels]. */
    fun linesOf(wheels: Wheels): List<String> = when (wheels) {
        is I2cWheels -> wheels.frames.flatMap { frame ->
            val write = "${board("i2c")}.write(${hex(wheels.address)}, bytes([${bytesOf(frame)}]))"
            if (wheels.pauseMilliseconds == 0) {
                listOf(write)
            } else {
                listOf(write, "${uses.import("utime", "sleep_us")}(${wheels.pauseMilliseconds * MICROSECONDS})")
            }
        }

        is ServoWheels -> {
            val pulse = uses.use(MicrobitHelper.PULSE)
            listOf(
                "${pin(wheels.left)}.write_analog($pulse(left))",
                "${pin(wheels.right)}.write_analog($pulse(-right))",
            )
        }

        is BridgeWheels -> listOf(bridge(wheels.left, "left"), bridge(wheels.right, "right"))
    }

    private fun bridge(pins: BridgePins, percent: String) =
        "${uses.use(MicrobitHelper.BRIDGE)}(${pin(pins.ahead)}, ${pin(pins.back)}, $percent)"

    private fun bytesOf(frame: Frame): String = frame.bytes.joinToString { byte ->
        when (byte) {
            is FrameByte.Fixed -> number(byte.value)
            is FrameByte.Direction -> "${byte.back} if ${nameOf(byte.side)} < 0 else ${byte.ahead}"
            is FrameByte.Power -> scaled("abs(${nameOf(byte.side)})", byte.full)
            is FrameByte.PowerAhead -> scaledAhead(nameOf(byte.side), byte.full)
            is FrameByte.PowerBack -> scaledAhead("-${nameOf(byte.side)}", byte.full)
            FrameByte.BackBits -> "(1 if left < 0 else 0) + (2 if right < 0 else 0)"
            FrameByte.Angle -> "degrees"
        }
    }

    private fun nameOf(side: WheelSide) = if (side == WheelSide.LEFT) "left" else "right"

    private fun scaled(percent: String, full: Int): String =
        if (full == PERCENT) percent else "${uses.use(MicrobitHelper.BYTE)}($percent)"

    private fun scaledAhead(percent: String, full: Int): String =
        if (full == PERCENT) "max(0, $percent)" else "${uses.use(MicrobitHelper.BYTE)}($percent)"

    /** The lines of a function that turns [servo] to an angle in `degrees`. */
    fun linesOf(servo: PenServo): List<String> = when (servo) {
        is I2cServo -> listOf("${board("i2c")}.write(${hex(servo.address)}, bytes([${bytesOf(servo.frame)}]))")

        is PinServo -> listOf(
            "time = 500 + degrees * 2000 // 180",
            "${pin(servo.pin)}.write_analog((time * 1023 + 10000) // 20000)",
        )
    }

    /** The line of a [call] before the program begins. */
    fun lineOf(call: MicrobitCall): String = when (call.native) {
        MicrobitNative.I2C_WRITE -> {
            val bytes = call.numbers.drop(1).joinToString(transform = ::number)
            "${board("i2c")}.write(${hex(call.numbers[0])}, bytes([$bytes]))"
        }

        MicrobitNative.PIN_PERIOD -> "${pin(call.numbers[0])}.set_analog_period(${call.numbers[1]})"
        else -> error("Nothing else makes a buggy ready.")
    }

    companion object {
        private const val PERCENT = 100
        private const val MICROSECONDS = 1000
        private const val HEXADECIMAL = 16

        /** [number] of a chip, as its maker writes it. */
        fun hex(number: Int): String = "0x" + number.toString(HEXADECIMAL).padStart(2, '0')

        fun number(value: Int): String = if (value < HEXADECIMAL) "$value" else hex(value)
    }
}
