package robotran.tower.line

import robotran.tower.RcxOpcode
import robotran.tower.ReceivedMessage

/**
 * Makes messages of the bytes that a tower hears. A packet has no length: it ends where no byte with its complement
 * follows, or with a pause.
 */
internal class MessageReader {
    private var heard = ByteArray(0)

    /** Whether bytes of a message are there that may be incomplete. */
    val isWaiting get() = heard.isNotEmpty()

    /** Takes [bytes] and returns the messages that are complete with them. */
    fun add(bytes: ByteArray): List<ReceivedMessage> {
        heard += bytes
        val messages = mutableListOf<ReceivedMessage>()
        while (true) {
            val next = nextHeader()
            val packet = packet()
            when {
                packet != null && (next != null || isNumber(packet)) -> messages += take(packet)
                next != null -> messages += raw(next)
                heard.size > MAX_BYTES -> messages += raw(heard.size)
                else -> return messages
            }
        }
    }

    /** A pause has come: returns what is there, complete or not. */
    fun pause(): List<ReceivedMessage> {
        if (heard.isEmpty()) return emptyList()
        val messages = packet()?.let { listOf(take(it)) }.orEmpty()
        return if (heard.isEmpty()) messages else messages + raw(heard.size)
    }

    /** The packet at the beginning, with its checksum; null if there is none so far. */
    private fun packet(): ByteArray? {
        val start = headerSize() ?: return null
        val pairs = pairsFrom(heard, start)
        val isWhole = pairs.size >= 2 && checksum(pairs.copyOf(pairs.size - 1)) == pairs.last()
        return pairs.takeIf { isWhole }
    }

    private fun isNumber(packet: ByteArray) = packet.size == NUMBER_BYTES && opcodeOf(packet) == RcxOpcode.MESSAGE

    private fun take(packet: ByteArray): ReceivedMessage {
        heard = heard.copyOfRange(checkNotNull(headerSize()) + 2 * packet.size, heard.size)
        return if (isNumber(packet)) {
            ReceivedMessage.Number(packet[1].toInt() and 0xFF)
        } else {
            ReceivedMessage.Packet(packet.copyOf(packet.size - 1).toList())
        }
    }

    private fun raw(size: Int): ReceivedMessage {
        val bytes = heard.copyOf(size).toList()
        heard = heard.copyOfRange(size, heard.size)
        return ReceivedMessage.Raw(bytes)
    }

    /** The size of the header at the beginning, of which the USB tower may have swallowed bytes; null if there is none. */
    private fun headerSize(): Int? = HEADERS.firstOrNull { startsWith(it, 0) }?.size

    /** Where the next whole header begins, behind the beginning. */
    private fun nextHeader(): Int? = (1..heard.size - HEADERS.first().size).firstOrNull {
        startsWith(HEADERS.first(), it) && !isInsidePacket(it)
    }

    /** A pair of 00 and FF behind 55 and AA looks like a header, but belongs to the packet. */
    private fun isInsidePacket(index: Int): Boolean {
        val start = headerSize() ?: return false
        return index < start + 2 * pairsFrom(heard, start).size
    }

    private fun startsWith(part: ByteArray, start: Int) =
        start + part.size <= heard.size && part.indices.all { heard[start + it] == part[it] }

    private fun opcodeOf(packet: ByteArray) = packet[0].toInt() and 0xFF and RcxOpcode.TOGGLE.inv()

    private companion object {
        val HEADERS = listOf(byteArrayOf(0x55, -1, 0), byteArrayOf(-1, 0), byteArrayOf(0))

        /** Opcode, number, checksum. */
        const val NUMBER_BYTES = 3

        /** More than any packet of leJOS or LEGO has on the line. */
        const val MAX_BYTES = 1024
    }
}
