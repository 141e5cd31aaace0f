package robotran.nxt.hardware

/** The I2C bus of one sensor port. A transaction takes its time: nine bits a byte. */
internal class I2cBus(private val clock: Clock) {
    /** What is plugged in; null if it is no sensor that sends bytes. */
    var device: I2cDevice? = null

    private var isEnabled = false
    private var isFast = false
    private var transaction: Transaction? = null
    private var result: Result = NOTHING

    /** [I2cStatus]. */
    val status: Int
        get() = when {
            !isEnabled -> I2cStatus.INVALID_PORT
            transaction != null -> I2cStatus.BUSY
            else -> minOf(result.count, I2cStatus.READY)
        }

    fun enable(mode: Int) {
        disable()
        isEnabled = true
        isFast = mode and I2cMode.HIGH_SPEED != 0
    }

    fun disable() {
        isEnabled = false
        transaction = null
        result = NOTHING
    }

    /** Begins to send [data] and then to receive [readLength] bytes. Returns 0 or an [I2cStatus]. */
    fun start(address: Int, data: ByteArray, readLength: Int): Int {
        if (!isEnabled) return I2cStatus.INVALID_PORT
        if (transaction != null) return I2cStatus.BUSY
        if (data.size > LONGEST || readLength !in 0..LONGEST) return I2cStatus.INVALID_LENGTH
        val bytes = (if (data.isEmpty()) 0 else 1 + data.size) + (if (readLength == 0) 0 else 1 + readLength)
        val bitsOfMillisecond = if (isFast) FAST_BITS else STANDARD_BITS
        val duration = (bytes * BITS_OF_BYTE * TENTHS + bitsOfMillisecond - 1) / bitsOfMillisecond
        transaction = Transaction(address, data, readLength, clock.milliseconds() + duration)
        result = NOTHING
        return I2cStatus.READY
    }

    /** Copies the answer to [into] and returns its length, or an [I2cStatus] below 0. The answer is then gone. */
    fun complete(into: ByteArray): Int {
        if (status == I2cStatus.INVALID_PORT || status == I2cStatus.BUSY) return status
        val taken = result
        result = NOTHING
        if (taken.count < 0) return taken.count
        val count = minOf(taken.count, into.size)
        taken.bytes.copyInto(into, 0, 0, count)
        return count
    }

    /** Ends the transaction if its time is over. */
    fun tick() {
        device?.tick()
        val ended = transaction ?: return
        if (clock.milliseconds() < ended.endsAt) return
        transaction = null
        val answering = device?.takeIf { it.address == ended.address }
        result = if (answering == null) FAULT else answered(answering, ended)
    }

    private fun answered(device: I2cDevice, transaction: Transaction): Result {
        if (transaction.data.isNotEmpty()) device.write(transaction.data)
        val bytes = if (transaction.readLength == 0) NO_BYTES else device.read(transaction.readLength)
        return Result(bytes.size, bytes)
    }

    private class Transaction(val address: Int, val data: ByteArray, val readLength: Int, val endsAt: Long)

    /** @property count of the bytes, or an [I2cStatus] below 0. */
    private class Result(val count: Int, val bytes: ByteArray)

    private companion object {
        /** Max bytes of a message. */
        const val LONGEST = 32

        const val BITS_OF_BYTE = 9
        const val TENTHS = 10

        // Tenths of bits a millisecond.
        const val STANDARD_BITS = 96
        const val FAST_BITS = 1_250

        val NO_BYTES = ByteArray(0)
        val NOTHING = Result(0, NO_BYTES)
        val FAULT = Result(I2cStatus.FAULT, NO_BYTES)
    }
}
