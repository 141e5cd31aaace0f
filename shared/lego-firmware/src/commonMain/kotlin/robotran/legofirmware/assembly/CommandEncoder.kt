package robotran.legofirmware.assembly

import robotran.legofirmware.image.ByteSink
import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.OperandNumbers
import robotran.legofirmware.instructions.encode
import robotran.legofirmware.messages.AssemblyMessages

/** Encodes the commands of [chunks], whose labels are all known. */
internal class CommandEncoder(
    private val sink: AssemblySink,
    private val messages: AssemblyMessages,
    target: FirmwareTarget,
    private val chunks: List<AssembledChunk>,
) {
    private val numbers = CheckedNumbers(sink, messages)
    private val firmwareCheck = FirmwareCheck(sink, messages, target)

    /** The code of [chunk]; anything if it has mistakes. */
    fun encode(chunk: AssembledChunk): CodeBytes {
        val bytes = ByteSink()
        for (command in chunk.commands) {
            when (val content = command.content) {
                is AssembledChunk.Content.Bytes -> content.bytes.forEach { bytes.byte(it) }

                is AssembledChunk.Content.Instruction -> {
                    val instruction = instructionOf(chunk, command, content)
                    if (instruction == null) repeat(content.size) { bytes.byte(0) }
                    instruction?.encode(command.address)?.toByteArray()?.forEach { bytes.byte(it.toInt()) }
                }
            }
        }
        return CodeBytes(bytes.toByteArray())
    }

    /** Null if it has a mistake. */
    private fun instructionOf(
        chunk: AssembledChunk,
        command: AssembledChunk.Command,
        content: AssembledChunk.Content.Instruction,
    ): Instruction? {
        val tokens = content.operands?.toMutableList() ?: return null
        val operands = content.form.kinds.map { kind ->
            if (kind.jump != null) {
                addressOf(chunk, command, content.form, tokens.removeFirst())
            } else {
                val ranges = OperandNumbers.rangesOf(kind)
                val values = ranges.map { numbers.number(tokens.removeFirst(), it, content.form.toString()) }
                if (null in values) null else OperandNumbers.toOperand(values.filterNotNull(), kind)
            }
        }
        if (null in operands) return null
        val instruction = Instruction(content.form.opcode, operands.filterNotNull())
        return instruction.takeIf { firmwareCheck.accepts(it, command.word) }
    }

    private fun addressOf(
        chunk: AssembledChunk,
        command: AssembledChunk.Command,
        form: CommandForm,
        token: Token,
    ): Operand? {
        val address = chunk.labels[token.text]
        val name = short(token.text)
        when {
            !token.isWord -> {
                sink.error(AssemblyError.LABEL_NEEDED, token, messages.labelNeeded(name, form.toString()))
            }

            address == null && chunks.any { token.text in it.labels } -> {
                sink.error(AssemblyError.LABEL_ELSEWHERE, token, messages.labelElsewhere(name))
            }

            address == null -> {
                val suggestion = alike(token.text, chunk.labels.keys.take(MOST_COMPARED))
                val message = messages.unknownLabel(name, suggestion)
                sink.error(AssemblyError.UNKNOWN_LABEL, token, message, suggestion)
            }

            !form.opcode.reaches(command.address, address) -> {
                val longForm = form.opcode.longForm?.mnemonic
                val message = messages.tooFar(form.opcode.mnemonic, name, longForm)
                sink.error(AssemblyError.TOO_FAR, command.word, message, longForm)
            }

            else -> return Operand.Address(address)
        }
        return null
    }

    private companion object {
        /** Labels compared with an unknown one. */
        const val MOST_COMPARED = 1000
    }
}
