package robotran.tower.simulated

/**
 * leJOS while no program runs. Written after its `src/platform/rcx/main.c`: what it answers, when it gives a download up
 * without a word, and when the program is there.
 *
 * @param room the bytes between the end of the firmware and where a download gives up: 13788 in 3.0, 14680 in 2.1.
 */
class SimulatedLejos(private val room: Int = 13_788) : SimulatedFirmware {
    /** The program that Run would start; null if there is none. */
    var program: ByteArray? = null
        private set

    private var received = ByteArray(0)
    private var isReadyToTransfer = false
    private var expectedNumber = 1
    private var lastOpcode: Byte = 0

    override fun handle(message: ByteArray): Reaction = when (opcodeOf(message)) {
        0x10 -> Reaction(answerTo(message))
        0x15 -> Reaction(answerTo(message, 0, 3, 0, 1, 0, 0, 0, 0))
        0x65 -> Reaction(answerTo(message), next = SimulatedRom())
        0x12 -> begin(message)
        0x45 -> block(message)
        else -> Reaction().also { giveUp() }
    }

    override fun switchOffAndOn() = giveUp()

    private fun begin(message: ByteArray): Reaction {
        lastOpcode = message[0]
        if (isReadyToTransfer) return Reaction().also { giveUp() }
        isReadyToTransfer = true
        program = null
        received = ByteArray(0)
        expectedNumber = 1
        return Reaction(answerTo(message, 0xCA, 0xF6))
    }

    private fun block(message: ByteArray): Reaction {
        val block = ReceivedBlock(message)
        val status = if (!block.isSound) {
            3
        } else if (isReadyToTransfer) {
            0
        } else {
            1
        }
        if (status != 0) {
            giveUp()
        } else if (message[0] != lastOpcode) {
            take(message[0], block)
        }
        return Reaction(answerTo(message, status))
    }

    private fun take(opcode: Byte, block: ReceivedBlock) {
        lastOpcode = opcode
        received += block.data
        when {
            expectedNumber != 1 && block.number == 0 -> end()
            received.size >= room || block.number != expectedNumber -> giveUp()
            else -> expectedNumber++
        }
    }

    private fun end() {
        val isImage = received.size > 1 && received[0] == 0xCA.toByte() && received[1] == 0xF6.toByte()
        if (isImage) program = received
        giveUp()
    }

    private fun giveUp() {
        isReadyToTransfer = false
        expectedNumber = 1
    }
}
