package robotran.legofirmware.run

import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.OpcodeUse
import robotran.legofirmware.instructions.instructionAt

/**
 * Answers requests over infrared light: messages of other bricks, and commands of a computer or a remote control.
 * Programs are not loaded this way.
 */
internal class Requests(private val core: Core, private val interpreter: Interpreter) {
    private val infrared get() = core.devices.infrared
    private val remote = RemoteControl(core)
    private var lastCode: Int? = null
    private val answers = ArrayDeque<List<Int>>()

    /** What the remote control wants and only the brick's shell can do; null if nothing. */
    fun takeCommand(): RemoteCommand? = remote.takeCommand()

    /** Takes a request, if one waits; returns whether one did. */
    fun tick(isRunning: Boolean): Boolean {
        if (infrared.isFree) {
            answers.removeFirstOrNull()?.let {
                core.calls.asFirmware { infrared.send(*it.toIntArray()) }
            }
        }
        val bytes = core.calls.asFirmware { infrared.receive() } ?: return false
        val placed = CodeBytes.of(*bytes.toIntArray()).instructionAt(0) ?: return false
        handle(bytes.first(), placed.instruction, isRunning)
        return true
    }

    private fun handle(code: Int, instruction: Instruction, isRunning: Boolean) {
        val isRepeated = code == lastCode && instruction.opcode != Opcode.MSGS && instruction.opcode != Opcode.REMOTE
        lastCode = code
        core.at(null)
        when (instruction.opcode) {
            Opcode.MSGS -> core.setMessage(instruction.number(0))
            Opcode.REMOTE -> remote.press(instruction.number(0))
            Opcode.POLL -> answerValue(code, core.values.read(instruction.value(0), core.requests))
            Opcode.POLLB -> answerValue(code, core.devices.power.readBattery())
            Opcode.POLLP -> answer(code, VERSIONS)
            Opcode.POLLD -> Unit

            else -> if (instruction.opcode.use == OpcodeUse.ANYWHERE) {
                if (!isRepeated) execute(instruction, isRunning)
                answer(code)
            }
        }
    }

    /** While no program runs, a start of its main task is one of the selected program, and other tasks do not start. */
    private fun execute(instruction: Instruction, isRunning: Boolean) = when {
        isRunning || instruction.opcode != Opcode.START -> interpreter.request(instruction)
        instruction.number(0) == 0 -> remote.startSelected()
        else -> Unit
    }

    private fun answerValue(code: Int, value: Int) = answer(
        code,
        listOf(
            value and BYTE,
            value shr Byte.SIZE_BITS and BYTE,
        ),
    )

    private fun answer(code: Int, bytes: List<Int> = emptyList()) {
        if (answers.size < MOST_ANSWERS) answers += listOf(code.inv() and BYTE) + bytes
    }

    private companion object {
        const val BYTE = 0xFF
        const val MOST_ANSWERS = 10

        /** ROM 3.1 and firmware 3.28, high bytes first. */
        val VERSIONS = listOf(0, 3, 0, 1, 0, 3, 0, 28)
    }
}
