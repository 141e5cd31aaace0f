package robotran.microbit.buggy

import robotran.microbit.program.MicrobitCall

/** How a program sets the power of the two wheels of a buggy. */
sealed interface Wheels {
    /** What a program does before it drives for the first time. */
    val start: List<MicrobitCall>

    /** What it does to give the wheels these percents, -100..100; 0 and 0 to stop. */
    fun calls(left: Int, right: Int): List<MicrobitCall>
}

/**
 * A chip that the board tells the power of the wheels over I2C. It keeps the last one until it is told another.
 *
 * @property address 7 bits.
 * @property setUp what the chip is told first.
 * @property frames what it is told for both wheels, each by one write: one for each wheel, or one for both.
 * @property pauseMilliseconds how long it needs after a frame.
 */
data class I2cWheels(
    val address: Int,
    val frames: List<Frame>,
    val setUp: List<List<Int>> = emptyList(),
    val pauseMilliseconds: Int = 0,
) : Wheels {
    override val start: List<MicrobitCall> get() = setUp.map { MicrobitCall.i2c(address, it) }

    override fun calls(left: Int, right: Int): List<MicrobitCall> =
        frames.map { MicrobitCall.i2c(address, it.of(left, right)) }
}

/** Two continuous servos on these pins; the right one is mounted the other way round. */
data class ServoWheels(val left: Int, val right: Int) : Wheels {
    override val start: List<MicrobitCall>
        get() = listOf(left, right).map { MicrobitCall.pinPeriod(it, ServoPulse.PERIOD_MILLISECONDS) }

    override fun calls(left: Int, right: Int): List<MicrobitCall> = listOf(
        MicrobitCall.pinAnalog(this.left, ServoPulse.ofSpeed(left)),
        MicrobitCall.pinAnalog(this.right, ServoPulse.ofSpeed(-right)),
    )
}

/** Two motors on a bridge; each has a pin that drives it ahead by pulses, and one that drives it back. */
data class BridgeWheels(val left: BridgePins, val right: BridgePins) : Wheels {
    override val start: List<MicrobitCall> get() = emptyList()

    override fun calls(left: Int, right: Int): List<MicrobitCall> = this.left.calls(left) + this.right.calls(right)
}

/** The pins of a motor on a bridge. */
data class BridgePins(val ahead: Int, val back: Int) {
    /** The pin that is to be low comes first, so that never both are high. */
    fun calls(percent: Int): List<MicrobitCall> {
        val ahead = MicrobitCall.pinAnalog(ahead, Frame.scaled(maxOf(0, percent), FULL))
        val back = MicrobitCall.pinAnalog(back, Frame.scaled(maxOf(0, -percent), FULL))
        return if (percent < 0) listOf(ahead, back) else listOf(back, ahead)
    }

    companion object {
        /** What `write_analog` takes for always high. */
        const val FULL = 1023
    }
}
