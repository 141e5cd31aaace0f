package robotran.tower.line

import robotran.tower.RcxOpcode

private val HEADER = byteArrayOf(0x55, 0xFF.toByte(), 0x00)

/** The complement of a byte. */
internal fun complement(byte: Byte): Byte = byte.toInt().inv().toByte()

/** The sum of [bytes] modulo 256. */
internal fun checksum(bytes: ByteArray): Byte = bytes.sum().toByte()

/** [message], an opcode with its parameters, as it is sent: header, each byte with its complement, checksum. */
internal fun frame(message: ByteArray): ByteArray {
    val bytes = message + checksum(message)
    return HEADER + ByteArray(bytes.size * 2) { if (it % 2 == 0) bytes[it / 2] else complement(bytes[it / 2]) }
}

/** The number of bytes on the line of a message of [bytes] bytes, opcode included. */
internal fun framedSize(bytes: Int): Int = HEADER.size + 2 * (bytes + 1)

/**
 * Finds the answer to a message with [opcode] in [heard] from index [start] on.
 *
 * The first bytes of the header may be missing, since the USB tower swallows them. The toggle must match: bytes come in
 * the order in which they were sent, so an answer to an older message cannot be taken for one to this.
 *
 * @param size the bytes of the answer behind the complement of the opcode.
 * @return these bytes; null if there is no undamaged answer.
 */
internal fun findAnswer(heard: ByteArray, start: Int, opcode: Int, size: Int): ByteArray? {
    val first = complement(opcode.toByte())
    for (index in start + 1 until heard.size) {
        if (heard[index] == first && heard[index - 1] == HEADER.last()) {
            val pairs = pairsFrom(heard, index)
            if (pairs.size >= size + 2 && checksum(pairs.copyOf(size + 1)) == pairs[size + 1]) {
                return pairs.copyOfRange(1, size + 1)
            }
        }
    }
    return null
}

/** The bytes from [start] on, as far as each is followed by its complement. */
internal fun pairsFrom(heard: ByteArray, start: Int): ByteArray {
    var end = start
    while (end + 1 < heard.size && heard[end + 1] == complement(heard[end])) end += 2
    return ByteArray((end - start) / 2) { heard[start + 2 * it] }
}

/** The opcode byte of a message that follows one with the opcode byte [last]. */
internal fun toggled(opcode: Int, last: Int): Int = if (opcode == last) opcode xor RcxOpcode.TOGGLE else opcode

/** [number] in two bytes, the low one first. */
internal fun twoBytes(number: Int): ByteArray = byteArrayOf(number.toByte(), (number shr Byte.SIZE_BITS).toByte())
