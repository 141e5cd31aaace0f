package robotran.rcxrom.infrared

/**
 * The packet format of a message: a header of three bytes, then each message byte followed by its complement, then the
 * sum of the message bytes and its complement. Sources: leJOS `rom.h`, Kekoa Proudfoot's opcode reference.
 */
internal object InfraredPacket {
    val HEADER = listOf(0x55, 0xFF, 0x00)

    fun encode(message: List<Int>): List<Int> =
        HEADER + (message + message.sum()).flatMap { listOf(it and BYTE, it.inv() and BYTE) }

    /** The message in [packet]; null if a complement or the sum is wrong. */
    fun decode(packet: List<Int>): List<Int>? {
        val body = if (packet.take(HEADER.size) == HEADER) packet.drop(HEADER.size) else packet
        val pairs = body.chunked(2)
        if (pairs.size < 2 || pairs.any { it.size < 2 || it[0] xor it[1] != BYTE }) return null
        val message = pairs.dropLast(1).map { it[0] }
        return message.takeIf { it.sum() and BYTE == pairs.last()[0] }
    }

    private const val BYTE = 0xFF
}
