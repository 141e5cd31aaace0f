package robotran.tower.simulated

/** Finds undamaged messages in the bytes that a brick hears, as its ROM does. */
internal class MessageDecoder {
    private var heard = mutableListOf<Byte>()

    /** The message that [byte] completes, without header, complements and checksum; null if there is none yet. */
    fun hear(byte: Byte): ByteArray? {
        heard += byte
        while (heard.isNotEmpty()) {
            when (val found = decode()) {
                is Found.Message -> {
                    heard.clear()
                    return found.bytes
                }

                Found.Incomplete -> return null
                Found.Nothing -> heard.removeAt(0)
            }
        }
        return null
    }

    private fun decode(): Found {
        heard.take(HEADER.size).forEachIndexed { index, byte -> if (byte != HEADER[index]) return Found.Nothing }
        val pairs = heard.drop(HEADER.size).chunked(2)
        if (pairs.any { it.size == 2 && it[0].toInt().inv().toByte() != it[1] }) return Found.Nothing
        val bytes = pairs.filter { it.size == 2 }.map { it[0] }
        val size = sizeOf(bytes) ?: return Found.Incomplete
        if (bytes.size <= size) return Found.Incomplete
        val message = bytes.take(size)
        return if (message.sum().toByte() == bytes[size]) Found.Message(message.toByteArray()) else Found.Nothing
    }

    /** The number of bytes of the message that begins with [bytes]; null if they do not tell it yet. */
    private fun sizeOf(bytes: List<Byte>): Int? {
        val opcode = bytes.firstOrNull()?.let { it.toInt() and 0xF7 } ?: return null
        if (opcode == BLOCK) {
            if (bytes.size < BLOCK_HEAD) return null
            return BLOCK_HEAD + (bytes[3].toInt() and 0xFF) + (bytes[4].toInt() and 0xFF) * 256 + 1
        }
        return 1 + when (val parameters = opcode and 7) {
            6 -> 0
            7 -> 1
            else -> parameters
        }
    }

    private sealed interface Found {
        class Message(val bytes: ByteArray) : Found

        data object Incomplete : Found

        data object Nothing : Found
    }

    private companion object {
        val HEADER = byteArrayOf(0x55, -1, 0)
        const val BLOCK = 0x45

        /** Opcode, number, length. */
        const val BLOCK_HEAD = 5
    }
}

/** [bytes] as they are sent. The tests of the framing do not use this, so that both are checked against each other. */
internal fun framed(bytes: List<Byte>): List<Byte> =
    listOf<Byte>(0x55, -1, 0) + (bytes + bytes.sum().toByte()).flatMap { listOf(it, it.toInt().inv().toByte()) }
