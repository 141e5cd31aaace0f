package robotran.legofirmware.listing

import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.OperandKind
import robotran.legofirmware.instructions.OperandNumbers

/** The operands of an instruction as in assembly text, separated by commas. */
internal fun Instruction.assemblyOperands(label: (Int) -> String): String {
    val kinds = opcode.operands.filter { it != OperandKind.ZERO }
    return operands.zip(kinds).joinToString(", ") { (operand, kind) ->
        when (operand) {
            is Operand.Address -> label(operand.address)
            else -> OperandNumbers.of(operand, kind).joinToString(", ")
        }
    }
}

/** The instruction that assembling its text gives: bits that the text does not show are 0. */
internal fun Instruction.canonical(): Instruction {
    val kinds = opcode.operands.filter { it != OperandKind.ZERO }
    return Instruction(
        opcode,
        operands.zip(kinds).map { (operand, kind) ->
            if (operand is Operand.Address) {
                operand
            } else {
                OperandNumbers.toOperand(
                    OperandNumbers.of(operand, kind),
                    kind,
                )
            }
        },
    )
}
