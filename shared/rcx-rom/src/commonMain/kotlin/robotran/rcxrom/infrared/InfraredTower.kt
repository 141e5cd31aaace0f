package robotran.rcxrom.infrared

/**
 * A device other than a brick that sends and receives messages. Like a real tower it hears all messages, including the
 * answers of bricks. A message ends after [SILENCE_MILLISECONDS] without light.
 */
class InfraredTower internal constructor(private val port: InfraredPort, private val echoes: Boolean) {
    private val sender = InfraredSender(port)
    private val hearing = mutableListOf<Int>()
    private val messages = ArrayDeque<List<Int>>()
    private var damaged = false
    private var silence = 0
    private var now = 0L

    /**
     * The messages heard so far, oldest first, each of bytes 0..255. Keeps only the newest hundred and drops damaged
     * ones.
     */
    val heard: List<List<Int>> get() = messages.toList()

    /**
     * Sends a message of bytes 0..255, the opcode first. Returns false if [message] is empty or the previous one is
     * still being sent.
     */
    fun send(message: List<Int>): Boolean {
        if (sender.remaining > 0 || message.isEmpty()) return false
        val packet = InfraredPacket.encode(message)
        sender.begin(now, packet.size, packet::get)
        return true
    }

    /** Advances by one millisecond. */
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
        /** A message ends after this silence; two of its bytes are never that far apart. */
        const val SILENCE_MILLISECONDS = 10

        /** Max bytes of a packet that is kept, of the 16-bit lengths that a brick can send. */
        const val LONGEST = 1_000
        const val KEPT = 100
    }
}
