package robotran.tower.simulated

/**
 * LEGO's ROM without firmware. It takes a message with the opcode byte of the last one for a resend and only answers.
 *
 * @param whenUnlocked what runs after a firmware was downloaded.
 */
class SimulatedRom(private val whenUnlocked: () -> SimulatedFirmware = { SimulatedLejos() }) : SimulatedFirmware {
    /** The bytes of the download so far. */
    var received = ByteArray(0)
        private set

    /** The start address of the download. */
    var start = 0
        private set

    private var checksum = 0
    private var isDownloading = false
    private var expectedNumber = 1
    private var lastOpcode: Byte = 0
    private var lastAnswer: List<Byte>? = null

    override fun handle(message: ByteArray): Reaction {
        if (message[0] == lastOpcode) return Reaction(lastAnswer)
        val reaction = handleNew(message)
        lastOpcode = message[0]
        lastAnswer = reaction.answer
        return reaction
    }

    private fun handleNew(message: ByteArray): Reaction = when (opcodeOf(message)) {
        0x10 -> Reaction(answerTo(message))
        0x15 -> Reaction(answerTo(message, 0, 3, 0, 1, 0, 0, 0, 0))
        0x65 -> Reaction(answerTo(message)).also { forget() }
        0x75 -> begin(message)
        0x45 -> Reaction(answerTo(message, block(ReceivedBlock(message))))
        0xA5 -> unlock(message)
        else -> Reaction()
    }

    private fun forget() {
        received = ByteArray(0)
        isDownloading = false
    }

    private fun begin(message: ByteArray): Reaction {
        forget()
        start = numberAt(message, 1)
        checksum = numberAt(message, 3)
        isDownloading = true
        expectedNumber = 1
        return Reaction(answerTo(message, 0))
    }

    private fun block(block: ReceivedBlock): Int = when {
        !isDownloading -> 6
        !block.isSound -> 3
        block.number != 0 && block.number != expectedNumber -> 2
        received.size + block.data.size > MEMORY -> 1

        else -> 0.also {
            received += block.data
            expectedNumber++
        }
    }

    private fun unlock(message: ByteArray): Reaction {
        val sum = received.take(SUMMED).sumOf { it.toInt() and 0xFF } and 0xFFFF
        if (!isDownloading || sum != checksum ||
            TEXT !in received.decodeToString()
        ) {
            return Reaction(answerTo(message, 4))
        }
        val answer = answerTo(message) + ANSWER.encodeToByteArray().toList()
        return Reaction(answer, whenUnlocked())
    }

    private companion object {
        const val MEMORY = 0x8000
        const val SUMMED = 0xCC00 - 0x8000
        const val TEXT = "Do you byte, when I knock?"
        const val ANSWER = "Just a bit off the block!"
    }
}
