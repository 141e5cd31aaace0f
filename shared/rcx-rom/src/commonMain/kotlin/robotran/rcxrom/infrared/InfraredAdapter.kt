package robotran.rcxrom.infrared

/**
 * A device other than a brick that sends and receives single bytes. It does not hear its own light, and begins to send
 * when no light has been seen for [QUIET_MILLISECONDS], so that a brick can answer first.
 */
class InfraredAdapter internal constructor(private val port: InfraredPort) {
    private val sender = InfraredSender(port)
    private val heard = ArrayDeque<Int>()
    private val waiting = ArrayDeque<List<Int>>()
    private var quiet = QUIET_MILLISECONDS
    private var now = 0L

    /** How far its light goes. */
    var range: InfraredRange
        get() = port.range
        set(range) {
            port.range = range
        }

    val isSending: Boolean get() = sender.remaining > 0 || waiting.isNotEmpty()

    /** How many bytes have been heard and not taken; it keeps the newest sixteen. Damaged ones are left out. */
    val available: Int get() = heard.size

    /** Sends a message of bytes 0..255, the opcode first, as the packet that a brick expects. */
    fun sendMessage(message: List<Int>) = send(InfraredPacket.encode(message))

    /** Sends [bytes], each 0..255, after what waits to be sent; drops them if too much does. */
    fun send(bytes: List<Int>) {
        if (bytes.isNotEmpty() && waiting.size < MOST_WAITING) waiting.addLast(bytes)
    }

    /** The byte heard [index] bytes after the oldest; null if there is none. */
    fun peek(index: Int): Int? = heard.getOrNull(index)

    /** Forgets the oldest [count] bytes. */
    fun drop(count: Int) = repeat(minOf(count, heard.size)) { heard.removeFirst() }

    /** Advances by one millisecond. */
    fun tick() {
        now++
        quiet = if (sender.remaining > 0) 0 else quiet + 1
        hear()
        if (sender.remaining == 0 && quiet > QUIET_MILLISECONDS) {
            waiting.removeFirstOrNull()?.let { sender.begin(now, it.size, it::get) }
        }
        sender.tick(now)
    }

    private fun hear() {
        var byte = port.hear(now)
        while (byte != null) {
            quiet = 0
            if (!byte.damaged && sender.remaining == 0) {
                if (heard.size == KEPT) heard.removeFirst()
                heard.addLast(byte.value)
            }
            byte = port.hear(now)
        }
    }

    companion object {
        /** Longer than a byte takes, and than a brick takes until it answers. */
        const val QUIET_MILLISECONDS = 15
        private const val KEPT = 16
        private const val MOST_WAITING = 8
    }
}
