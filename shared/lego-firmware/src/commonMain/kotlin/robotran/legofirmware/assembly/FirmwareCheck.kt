package robotran.legofirmware.assembly

import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.FirstFirmware
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.OpcodeUse
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.OperandKind
import robotran.legofirmware.instructions.ValueSource
import robotran.legofirmware.messages.AssemblyMessages

/** Checks whether the firmware [target] knows what an instruction needs. */
internal class FirmwareCheck(
    private val sink: AssemblySink,
    private val messages: AssemblyMessages,
    private val target: FirmwareTarget,
) {
    /** Reports what the firmware lacks at [token], and returns false if that is an error. */
    fun accepts(instruction: Instruction, token: Token): Boolean {
        val opcode = instruction.opcode
        if (opcode.firmware > target) return refuse(token, messages.newerCommand(opcode.mnemonic))
        if (opcode.use == OpcodeUse.REQUEST) {
            sink.warn(AssemblyError.REQUEST_ONLY, token, messages.requestOnly(opcode.mnemonic))
        }
        val values = instruction.operands.flatMap {
            when (it) {
                is Operand.Value -> listOf(it)
                is Operand.Test -> listOf(it.left, it.right)
                else -> emptyList()
            }
        }
        val unknown = values.find { ValueSource.of(it.source) == null }
        if (unknown != null) {
            sink.warn(AssemblyError.UNKNOWN_SOURCE, token, messages.unknownSource(unknown.source))
        }
        return target != FirmwareTarget.RCX || firstFirmwareAccepts(instruction, values, token)
    }

    private fun firstFirmwareAccepts(instruction: Instruction, values: List<Operand.Value>, token: Token): Boolean {
        val newer = values.find { ValueSource.of(it.source)?.firmware == FirmwareTarget.RCX2 }
        if (newer != null) return refuse(token, messages.newerSource(newer.source))
        val variables = values.filter { it.source == ValueSource.VARIABLE.code }.map { it.argument } +
            instruction.operands.zip(instruction.opcode.operands)
                .mapNotNull { (operand, kind) -> (operand as? Operand.Number)?.takeIf { kind == OperandKind.VARIABLE } }
                .map { it.value }
        val local = variables.find { it >= FirmwareLimits.GLOBAL_VARIABLES }
        if (local != null) return refuse(token, messages.newerVariable(local))
        val refused = FirstFirmware.refusedSource(instruction)
        if (refused != null) {
            val message = messages.restrictedSource(instruction.opcode.mnemonic, refused)
            sink.warn(AssemblyError.RESTRICTED_SOURCE, token, message)
        }
        return true
    }

    private fun refuse(token: Token, message: String): Boolean {
        sink.error(AssemblyError.NEWER_FIRMWARE, token, message)
        return false
    }
}
