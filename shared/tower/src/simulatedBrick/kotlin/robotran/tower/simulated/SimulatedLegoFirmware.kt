package robotran.tower.simulated

/**
 * LEGO's firmware 3.32.
 *
 * @param millivolts of the batteries.
 * @param room the bytes that all tasks and subroutines have together.
 */
class SimulatedLegoFirmware(var millivolts: Int = 8700, private val room: Int = 6000) : SimulatedFirmware {
    /** The code of each part: `task 0` in slot 1 is `1 task 0`. */
    val parts = mutableMapOf<String, ByteArray>()
    var slot = 1
        private set
    var isRunning = false
        private set

    /** Hours and minutes. */
    var clock: Pair<Int, Int>? = null
        private set

    /** The last message that came, 0 if none has. */
    var message = 0
        private set

    private var part: String? = null
    private var size = 0
    private var code = ByteArray(0)
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
        0x15 -> Reaction(answerTo(message, 0, 3, 0, 1, 0, 3, 3, 2))
        0x12 -> Reaction(answerTo(message, 0, 0))
        0x30 -> Reaction(answerTo(message, millivolts and 0xFF, millivolts shr 8))
        0x65 -> Reaction(answerTo(message), next = SimulatedRom())
        0x45 -> Reaction(answerTo(message, block(ReceivedBlock(message))))
        0x25 -> Reaction(answerTo(message, begin("task", message)))
        0x35 -> Reaction(answerTo(message, begin("sub", message)))
        0xF7 -> Reaction().also { this.message = message[1].toInt() and 0xFF }
        else -> if (obey(message)) Reaction(answerTo(message)) else Reaction()
    }

    /** Commands that are answered with nothing but the complement of the opcode. */
    private fun obey(message: ByteArray): Boolean {
        when (opcodeOf(message)) {
            0x10 -> Unit
            0x22 -> clock = message[1].toInt() to message[2].toInt()
            0x40 -> delete("task")
            0x70 -> delete("sub")
            0x50 -> isRunning = false
            0x71 -> isRunning = "$slot task ${message[1]}" in parts
            0x91 -> select(message[1] + 1)
            else -> return false
        }
        return true
    }

    private fun select(number: Int) {
        slot = number
        isRunning = false
    }

    private fun delete(kind: String) {
        isRunning = false
        parts.keys.removeAll { it.startsWith("$slot $kind") }
    }

    private fun begin(kind: String, message: ByteArray): Int {
        size = numberAt(message, 4)
        part = null
        if (parts.values.sumOf { it.size } + size > room) return 1
        part = "$slot $kind ${message[2]}"
        code = ByteArray(0)
        expectedNumber = 1
        return 0
    }

    private fun block(block: ReceivedBlock): Int {
        val name = part ?: return 6
        if (!block.isSound) return 3
        if (block.number != 0 && block.number != expectedNumber) return 2
        code += block.data
        expectedNumber++
        if (block.number == 0) {
            part = null
            if (code.size == size) parts[name] = code
        }
        return 0
    }
}
