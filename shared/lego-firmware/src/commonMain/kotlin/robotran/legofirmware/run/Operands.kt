package robotran.legofirmware.run

import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Operand

/** The operand at [index], which the kind of the opcode says is a number. */
internal fun Instruction.number(index: Int): Int = (operands[index] as Operand.Number).value

/** The operand at [index], which the kind of the opcode says is a value or a place. */
internal fun Instruction.value(index: Int): Operand.Value = operands[index] as Operand.Value

/** The address of the opcode, which its kind says is there. */
internal fun Instruction.jumpTarget(): Int = (operands.last() as Operand.Address).address
