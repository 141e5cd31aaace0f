package robotran.rcxrom.infrared

/**
 * Sends bytes at 2400 baud, each with a start bit, odd parity and a stop bit.
 *
 * @param sentByte called with the milliseconds of a byte's first and last bit when it has been sent.
 */
internal class InfraredSender(
    private val port: InfraredPort,
    private val sentByte: (begin: Long, end: Long) -> Unit = { _, _ -> },
) {
    private var begun = 0L
    private var sent = 0
    private var length = 0
    private var byteAt: (Int) -> Int = { 0 }

    /** Number of bytes not sent yet, including the current one. */
    val remaining: Int get() = length - sent

    /** Starts sending [length] bytes; reads each from [byteAt] at the end of its transmission. */
    fun begin(now: Long, length: Int, byteAt: (Int) -> Int) {
        begun = now
        sent = 0
        this.length = length
        this.byteAt = byteAt
        port.beginLight(now)
    }

    fun stop() {
        length = sent
    }

    /** Advances by the millisecond that ends at [now]. */
    fun tick(now: Long) {
        if (remaining == 0) return
        port.extendLight(now)
        while (remaining > 0 && endOf(sent + 1) <= now) {
            val begin = endOf(sent)
            val end = endOf(sent + 1)
            port.send(byteAt(sent), begin, end)
            sent++
            sentByte(begin, end)
        }
    }

    /** The millisecond in which the transmission of [bytes] bytes ends. */
    private fun endOf(bytes: Int): Long = begun + (bytes.toLong() * MILLIBITS_OF_BYTE + BAUD - 1) / BAUD

    private companion object {
        const val BAUD = 2400

        /** Eleven bits a byte, in thousandths, because time is in milliseconds. */
        const val MILLIBITS_OF_BYTE = 11_000
    }
}
