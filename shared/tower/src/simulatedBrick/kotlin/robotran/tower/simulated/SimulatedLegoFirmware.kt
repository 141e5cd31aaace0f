package robotran.tower.simulated

/**
 * LEGO's firmware.
 *
 * @param millivolts of the batteries.
 * @param room the bytes that all tasks and subroutines have together.
 * @param version behind the point: firmware 2.0 is 3.28 or 3.32, firmware 1.0 is 3.9.
 */
class SimulatedLegoFirmware(var millivolts: Int = 8700, private val room: Int = 6000, private val version: Int = 32) :
    SimulatedFirmware {
    /** The code of each part: `task 0` in slot 1 is `1 task 0`. */
    val parts = mutableMapOf<String, ByteArray>()
    var slot = 1
        private set
    var isRunning = false
        private set

    /** Hours and minutes. */
    var clock: Pair<Int, Int>? = null
        private set

    /** The entries of the datalog as types and values, without the first, which counts them; null for no datalog. */
    var datalog: List<Pair<Int, Int>>? = null

    /** The sounds that were asked for. */
    val sounds = mutableListOf<Int>()

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
        0x15 -> Reaction(answerTo(message, 0, 3, 0, 1, 0, 3, version / 10, version % 10))
        0x12 -> Reaction(answerTo(message, 0, 0))
        0x30 -> Reaction(answerTo(message, millivolts and 0xFF, millivolts shr 8))
        0x65 -> Reaction(answerTo(message), next = SimulatedRom())
        0x45 -> Reaction(answerTo(message, block(ReceivedBlock(message))))
        0x25 -> Reaction(answerTo(message, begin("task", message)))
        0x35 -> Reaction(answerTo(message, begin("sub", message)))
        0xA4 -> Reaction(entries(numberAt(message, 1), numberAt(message, 3))?.let { answerTo(message, *it) })
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
            0x51 -> sounds += message[1].toInt()
            0x71 -> isRunning = "$slot task ${message[1]}" in parts
            0x91 -> select(message[1] + 1)
            else -> return false
        }
        return true
    }

    /** The bytes of [count] entries from [first] on; null if there are not so many. */
    private fun entries(first: Int, count: Int): IntArray? {
        val all = datalog?.let { listOf(0xFF to it.size + 1) + it } ?: listOf(0 to 0)
        if (first + count > all.size) return null
        return all.subList(first, first + count)
            .flatMap { (type, value) -> listOf(type, value and 0xFF, value shr 8 and 0xFF) }.toIntArray()
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
