package robotran.rcxrom.infrared

/**
 * Something beside the bricks that sends and hears messages. Like a real tower it hears all messages, answers of bricks
 * too, and believes a message to be over when the light stays away for a while.
 */
class InfraredTower internal constructor(private val port: InfraredPort, private val echoes: Boolean) {
    private val sender = InfraredSender(port)
    private val hearing = mutableListOf<Int>()
    private val messages = ArrayDeque<List<Int>>()
    private var damaged = false
    private var silence = 0
    private var now = 0L

    /**
     * The messages heard so far, the oldest first, each of bytes 0..255; only the newest hundred, and none that came
     * damaged.
     */
    val heard: List<List<Int>> get() = messages.toList()

    /**
     * Sends a message of bytes 0..255, the first of them the opcode; false if the one before is still on its way or
     * there are none.
     */
    fun send(message: List<Int>): Boolean {
        if (sender.remaining > 0 || message.isEmpty()) return false
        val packet = InfraredPacket.encode(message)
        sender.begin(now, packet.size, packet::get)
        return true
    }

    /** One millisecond. */
    fun tick() {
        now++
        hear()
        sender.tick(now)
    }

    private fun hear() {
        var byte = port.hear(now)
        silence = if (byte == null) minOf(silence + 1, SILENCE_MILLISECONDS) else 0
        while (byte != null) {
            if (hearing.size < LONGEST) hearing += byte.value
            damaged = damaged || byte.damaged
            byte = port.hear(now)
        }
        if (silence == SILENCE_MILLISECONDS && hearing.isNotEmpty()) endMessage()
    }

    private fun endMessage() {
        val message = if (damaged) null else InfraredPacket.decode(hearing)
        hearing.clear()
        damaged = false
        if (message == null) return
        if (messages.size == KEPT) messages.removeFirst()
        messages.addLast(message)
        if (echoes) send(message)
    }

    private companion object {
        /** After so long a message is over; two bytes of it are never so far from each other. */
        const val SILENCE_MILLISECONDS = 10

        /** The bytes of the longest packet that is kept, of the 16-bit lengths that a brick can send. */
        const val LONGEST = 1_000
        const val KEPT = 100
    }
}
