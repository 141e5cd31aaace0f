package robotran.nxt.bluetooth

import robotran.nxt.hardware.Clock

/** What has become of a [BluetoothLink]; [code] is what a program sees. */
enum class LinkStatus(val code: Int) {
    /** The other robot has not answered. */
    WAITING(0),
    OPEN(1),

    /** Closed by either side, or refused. */
    CLOSED(-1),
}

/**
 * What connects two robots.
 *
 * @property connectMilliseconds how long connecting takes.
 * @property delayMilliseconds from the moment when a byte has left until it arrives.
 * @property bytesPerMillisecond how many bytes leave in a millisecond.
 */
enum class LinkMedium(val connectMilliseconds: Long, val delayMilliseconds: Long, val bytesPerMillisecond: Long) {
    BLUETOOTH(1_000, 60, 20),

    /** A cable from port 4 to port 4. */
    RS485(300, 4, 40),
}

/**
 * One side of a connection between two robots, or the attempt to make one. Bytes arrive in order, as late and as many in
 * a millisecond as the [medium] has it.
 *
 * @property number unique in the run of a program, from 0.
 */
class BluetoothLink internal constructor(
    val number: Int,
    internal val isListening: Boolean,
    val medium: LinkMedium,
    private val clock: Clock,
) {
    private var peer: BluetoothLink? = null
    private val arriving = ArrayDeque<Packet>()
    private var isClosed = false
    private var closesAt = NEVER

    /** When the last byte has left, in the time that a byte takes. */
    private var lineFreeAt = 0L

    /** The name of the other robot; null while nobody has answered. */
    var partner: String? = null
        private set

    val status: LinkStatus
        get() = when {
            isClosed || clock.milliseconds() >= closesAt -> LinkStatus.CLOSED
            peer == null -> LinkStatus.WAITING
            else -> LinkStatus.OPEN
        }

    /** Whether bytes are leaving. */
    val isSending: Boolean get() = status == LinkStatus.OPEN && lineFreeAt > byteTime()

    /** Number of bytes that have arrived. */
    val available: Int get() = arriving.sumOf { if (it.arrivesAt <= clock.milliseconds()) it.rest else 0 }

    /**
     * Takes bytes that have arrived and copies them to [into], as many as fit.
     *
     * @return how many; 0 if none have arrived, -1 if none will come.
     */
    fun read(into: ByteArray): Int {
        var count = 0
        while (count < into.size) {
            val packet = arriving.firstOrNull()?.takeIf { it.arrivesAt <= clock.milliseconds() } ?: break
            count = packet.take(into, count)
            if (packet.rest == 0) arriving.removeFirst()
        }
        val isOver = count == 0 && into.isNotEmpty() && arriving.isEmpty() && status == LinkStatus.CLOSED
        return if (isOver) -1 else count
    }

    /** Sends [bytes] as far as there is room. Returns how many, -1 if the link is not open. */
    internal fun write(bytes: ByteArray): Int {
        val receiver = peer
        if (receiver == null || status != LinkStatus.OPEN) return -1
        val begin = maxOf(byteTime(), lineFreeAt)
        val count = minOf(bytes.size.toLong(), BUFFER - (begin - byteTime())).toInt()
        if (count <= 0) return 0
        lineFreeAt = begin + count
        receiver.arriving += Packet(bytes.copyOf(count), arrivalTime())
        return count
    }

    internal fun close() {
        if (status == LinkStatus.OPEN) peer?.closesAt = arrivalTime()
        isClosed = true
    }

    internal fun connect(own: String, other: BluetoothLink, otherName: String) {
        peer = other
        other.peer = this
        partner = otherName
        other.partner = own
    }

    private fun byteTime() = clock.milliseconds() * medium.bytesPerMillisecond

    /** When what has been sent until now has arrived. */
    private fun arrivalTime(): Long {
        val perMillisecond = medium.bytesPerMillisecond
        val left = (maxOf(byteTime(), lineFreeAt) + perMillisecond - 1) / perMillisecond
        return left + medium.delayMilliseconds
    }

    private class Packet(private val bytes: ByteArray, val arrivesAt: Long) {
        private var taken = 0
        val rest: Int get() = bytes.size - taken

        /** Copies as much as fits to [into] from [at] on, and returns where it ends. */
        fun take(into: ByteArray, at: Int): Int {
            val count = minOf(rest, into.size - at)
            bytes.copyInto(into, at, taken, taken + count)
            taken += count
            return at + count
        }
    }

    companion object {
        /** How many bytes can wait to be sent. */
        const val BUFFER = 254L

        private const val NEVER = Long.MAX_VALUE
    }
}
