package robotran.legofirmware.run

import robotran.legofirmware.image.CodeBytes
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.OperandKind
import robotran.legofirmware.instructions.ValueSource
import robotran.legofirmware.instructions.instructionAt

/** Which variables the commands of a program name. */
internal object VariablesUsed {
    fun of(image: RcxImage): Set<Int> = image.chunks.flatMapTo(mutableSetOf()) { of(it.code) }

    private fun of(code: CodeBytes): Set<Int> = buildSet {
        var address = 0
        while (address < code.size) {
            val placed = code.instructionAt(address)
            if (placed != null) addAll(of(placed.instruction))
            address = placed?.end ?: (address + 1)
        }
    }

    private fun of(instruction: Instruction): List<Int> {
        val kinds = instruction.opcode.operands.filter { it != OperandKind.ZERO }
        return instruction.operands.zip(kinds).flatMap { (operand, kind) ->
            when (operand) {
                is Operand.Number -> listOfNotNull(operand.value.takeIf { kind == OperandKind.VARIABLE })
                is Operand.Value -> listOfNotNull(variable(operand))
                is Operand.Test -> listOfNotNull(variable(operand.left), variable(operand.right))
                is Operand.Address -> emptyList()
            }
        }
    }

    private fun variable(value: Operand.Value): Int? =
        value.argument.takeIf { value.source == ValueSource.VARIABLE.code }
}
