package robotran.hublink.frame

import robotran.hublink.u8

/**
 * Frames of the serial line: LEGO's variant of COBS, in which 1 and 2 appear at the ends alone. A message is cut into
 * blocks; the code byte of each tells its length and which of the values 0, 1 and 2 stands behind it.
 */
object Cobs {
    /** Ends a frame. */
    const val END: Byte = 0x02

    /** May stand in front of a frame. */
    const val START: Byte = 0x01

    private const val MASK = 0x03

    /** The longest block with its code byte. */
    private const val BLOCK = 84
    private const val CODE_OFFSET = 2

    /** The code of a full block without a value behind it. */
    private const val FULL = 0xFF
    private const val ESCAPED_VALUES = 3

    /** The frame of [message], with its end. */
    fun encode(message: ByteArray): ByteArray {
        val frame = mutableListOf<Byte>()
        var block = mutableListOf<Byte>()

        fun close(code: Int) {
            frame += code.toByte()
            frame += block
            block = mutableListOf()
        }
        for (byte in message) {
            val value = byte.toInt() and 0xFF
            if (value < ESCAPED_VALUES) {
                close(value * BLOCK + block.size + 1 + CODE_OFFSET)
            } else {
                block += byte
                if (block.size == BLOCK) close(FULL)
            }
        }
        // The end of a message counts as a 0 that is not there.
        close(block.size + 1 + CODE_OFFSET)
        return frame.map { (it.toInt() xor MASK).toByte() }.toByteArray() + END
    }

    /** The message of [frame], which has no end and no start any more; null if it is spoiled. */
    fun decode(frame: ByteArray): ByteArray? {
        val message = mutableListOf<Byte>()
        var place = 0
        while (place < frame.size) {
            val code = frame.u8(place) xor MASK
            if (code <= CODE_OFFSET) return null
            val isFull = code == FULL
            val length = if (isFull) BLOCK else (code - CODE_OFFSET - 1) % BLOCK
            val end = place + 1 + length
            if (end > frame.size) return null
            for (index in place + 1 until end) message += (frame.u8(index) xor MASK).toByte()
            if (!isFull) message += ((code - CODE_OFFSET - 1) / BLOCK).toByte()
            place = end
            if (isFull && place == frame.size) return null
        }
        // The last value is that of the end.
        return if (message.isEmpty() || message.last() != 0.toByte()) null else message.dropLast(1).toByteArray()
    }
}
