package robotran.nxt.hardware

/** A sensor that sends bytes over I2C. */
interface I2cDevice {
    /** The address, eight bits of which the lowest is 0. */
    val address: Int

    /** What it measures, for somebody who looks at the brick; null if it has nothing to tell. */
    val reading: Int? get() = null

    /** Whether it has measured [reading]: not while it is off, nor before its first measurement. */
    val hasMeasured: Boolean get() = true

    /** Receives a message: the number of a register, and what to write there, if anything. */
    fun write(data: ByteArray)

    /** Sends [count] bytes from the register on that the last message named. */
    fun read(count: Int): ByteArray

    /** Lets a millisecond pass. */
    fun tick() = Unit

    /** The port has taken its power away. */
    fun switchOff() = Unit
}

/** The status of a sensor port's I2C bus, as leJOS NXJ's `I2CPort` has it. */
object I2cStatus {
    const val READY = 0
    const val INVALID_PORT = -1
    const val BUSY = -2

    /** No device answers. */
    const val FAULT = -3
    const val INVALID_LENGTH = -4
}

/** Modes of a sensor port's I2C bus. */
object I2cMode {
    const val STANDARD = 0
    const val LEGO = 1

    /** A bit: 125 instead of 9.6 thousand bits a second. */
    const val HIGH_SPEED = 8
}
