package robotran.microbitlink.simulated

import robotran.microbitlink.hex.HexMemory

/**
 * A micro:bit at the other end of the wire: DAPLink with its stream and its serial line, flash, and a Python.
 *
 * @param memory what its flash holds.
 * @param boardId the first four digits of its serial number.
 * @param daplink the version of DAPLink, which one before 254 does not tell.
 */
class SimulatedBoard(
    memory: HexMemory,
    private val boardId: String = "9904",
    private val daplink: Int = 257,
    private var baudRate: Int = 115_200,
) {
    private val stream = FlashStream(memory, isNewer = daplink >= FIRST_NEWER)

    /** What its flash holds. */
    val memory: HexMemory get() = stream.memory

    /** What runs on it. */
    val python = SimulatedPython(memory) { stream.replace(it) }

    /** How often the board was started again. */
    var starts = 0
        private set

    /** The answer to [packet]. */
    fun answer(packet: ByteArray, faults: CableFaults): ByteArray {
        val command = packet[0]
        val answer = when (command.toInt() and 0xFF) {
            0x00 -> info(packet[1].toInt())
            0x80 -> text("${boardId}36020052820c0e53b70b00000000000000".padEnd(LONGEST_NUMBER, '7'))
            0x81 -> numberBytes(baudRate) + byteArrayOf(0, 0, 8)
            0x82 -> setBaudRate(packet)
            0x83 -> python.take(PAYLOAD).let { byteArrayOf(it.size.toByte()) + it }
            0x84 -> hear(packet, faults)
            0x89 -> byteArrayOf(1)
            0x8A -> byteArrayOf(stream.open(packet[1].toInt()).toByte())
            0x8B -> close()
            0x8C -> byteArrayOf(stream.write(payload(packet), faults.injectedError).toByte())
            else -> ByteArray(0)
        }
        return byteArrayOf(command) + answer
    }

    private fun info(id: Int): ByteArray = when {
        id == 1 -> text("Arm")
        id == PRODUCT_VERSION && daplink >= FIRST_NEWER -> text(daplink.toString().padStart(4, '0'))
        else -> byteArrayOf(0)
    }

    private fun setBaudRate(packet: ByteArray): ByteArray {
        baudRate = (1..4).sumOf { (packet[it].toInt() and 0xFF) shl ((it - 1) * Byte.SIZE_BITS) }
        start()
        return byteArrayOf(1)
    }

    private fun hear(packet: ByteArray, faults: CableFaults): ByteArray {
        payload(packet).filterNot { faults.isByteLost() }.forEach { python.hear(it) }
        return byteArrayOf(1)
    }

    private fun close(): ByteArray {
        val number = stream.close()
        start()
        return byteArrayOf(number.toByte())
    }

    private fun start() {
        starts++
        python.start(memory)
    }

    private fun payload(packet: ByteArray): ByteArray = packet.copyOfRange(2, 2 + minOf(packet[1].toInt(), PAYLOAD))

    private fun text(text: String): ByteArray = byteArrayOf(text.length.toByte()) + text.encodeToByteArray()

    private fun numberBytes(number: Int) = ByteArray(Int.SIZE_BYTES) { (number shr (it * Byte.SIZE_BITS)).toByte() }

    private companion object {
        const val FIRST_NEWER = 254
        const val PRODUCT_VERSION = 9
        const val PAYLOAD = 62
        const val LONGEST_NUMBER = 48
    }
}
