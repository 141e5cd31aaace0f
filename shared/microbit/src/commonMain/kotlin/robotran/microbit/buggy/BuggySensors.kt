package robotran.microbit.buggy

import robotran.microbit.program.MicrobitCall

/** A sensor of a buggy that looks down for a line. */
sealed interface LineSensor {
    /** Whether it tells greys; otherwise it knows only light and dark. */
    val isGrey: Boolean get() = false
}

/** A pin that is 0 or 1; [darkIs] over something dark. */
data class PinLine(val pin: Int, val darkIs: Int) : LineSensor

/** A pin with a voltage, 0..1023, that is high over something dark if [isDarkHigh]. */
data class AnalogLine(val pin: Int, val isDarkHigh: Boolean) : LineSensor {
    override val isGrey: Boolean get() = true
}

/**
 * A bit of a byte that a chip answers.
 *
 * @property address 7 bits.
 * @property ask what is written before the byte is read.
 * @property bit from 0, the lowest.
 * @property darkIs the bit over something dark.
 */
data class I2cLine(val address: Int, val ask: List<Int>, val bit: Int, val darkIs: Int = 1) : LineSensor

/** The pins of a distance sensor like an HC-SR04; they may be the same. */
data class SonarPins(val trigger: Int, val echo: Int)

/** A servo that moves the pen. */
sealed interface PenServo {
    val start: List<MicrobitCall> get() = emptyList()

    /** Turns it to this angle, 0..180 degrees. */
    fun turnTo(degrees: Int): MicrobitCall

    companion object {
        /** Where the servo stands with the pen lifted, and where with its tip on the paper: ours, for a lever to the front. */
        const val UP_DEGREES = 90
        const val DOWN_DEGREES = 45
    }
}

/** One that the chip of the buggy turns. */
data class I2cServo(val address: Int, val frame: Frame) : PenServo {
    override fun turnTo(degrees: Int): MicrobitCall = MicrobitCall.i2c(address, frame.of(degrees))
}

/** One on a pin of the board. */
data class PinServo(val pin: Int) : PenServo {
    override val start: List<MicrobitCall>
        get() = listOf(MicrobitCall.pinPeriod(pin, ServoPulse.PERIOD_MILLISECONDS))

    override fun turnTo(degrees: Int): MicrobitCall = MicrobitCall.pinAnalog(pin, ServoPulse.ofAngle(degrees))
}
