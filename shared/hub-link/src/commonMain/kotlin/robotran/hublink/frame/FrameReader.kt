package robotran.hublink.frame

/** Finds the messages in a stream of bytes. Spoiled and endless frames are dropped; the next one is read again. */
class FrameReader {
    private val frame = mutableListOf<Byte>()
    private var isTooLong = false

    /** The messages that end in [bytes]. */
    fun add(bytes: ByteArray): List<ByteArray> {
        val messages = mutableListOf<ByteArray>()
        for (byte in bytes) {
            when {
                byte == Cobs.END -> {
                    if (frame.isNotEmpty() && !isTooLong) Cobs.decode(frame.toByteArray())?.let { messages += it }
                    clear()
                }

                byte == Cobs.START -> clear()

                frame.size == MAX_FRAME -> isTooLong = true

                else -> frame += byte
            }
        }
        return messages
    }

    private fun clear() {
        frame.clear()
        isTooLong = false
    }

    private companion object {
        /** Far more than a hub sends. */
        const val MAX_FRAME = 1_024
    }
}
