package robotran.tower.simulated

/** What answers the messages to a brick: its ROM, or a firmware. */
interface SimulatedFirmware {
    /** Handles a message of opcode and parameters. */
    fun handle(message: ByteArray): Reaction

    /** The brick is switched off and on again. */
    fun switchOffAndOn() = Unit
}

/**
 * What follows from a message.
 *
 * @property answer the bytes of the answer, opcode first; null if there is none.
 * @property next what answers the messages from now on; null if it is the same.
 */
class Reaction(val answer: List<Byte>? = null, val next: SimulatedFirmware? = null)

/** The answer to [message]: the complement of its opcode, and [bytes]. */
internal fun answerTo(message: ByteArray, vararg bytes: Int): List<Byte> =
    listOf(message[0].toInt().inv().toByte()) + bytes.map { it.toByte() }

internal fun opcodeOf(message: ByteArray): Int = message[0].toInt() and 0xF7

internal fun numberAt(message: ByteArray, index: Int): Int =
    (message[index].toInt() and 0xFF) + (message[index + 1].toInt() and 0xFF) * 256

/** The data of a block, and whether its own checksum is right. */
internal class ReceivedBlock(message: ByteArray) {
    val number = numberAt(message, 1)
    val data = message.copyOfRange(5, message.size - 1)
    val isSound = data.sum().toByte() == message.last()
}
