package robotran.legofirmware.instructions

import robotran.legofirmware.image.CodeBytes

/**
 * An instruction of a program.
 *
 * @property operands one for each of [Opcode.operands] but those of kind [OperandKind.ZERO], in their order.
 */
data class Instruction(val opcode: Opcode, val operands: List<Operand> = emptyList()) {
    constructor(opcode: Opcode, vararg operands: Operand) : this(opcode, operands.asList())

    /** The address that the instruction may continue at; null if it has none. */
    val target: Int? get() = operands.firstNotNullOfOrNull { (it as? Operand.Address)?.address }
}

/**
 * An instruction in the code of a task or subroutine.
 *
 * @property address of its first byte.
 */
data class PlacedInstruction(val address: Int, val instruction: Instruction) {
    /** The address after its last byte. */
    val end: Int get() = address + instruction.opcode.size
}

/**
 * The bytes of the instruction at [address].
 *
 * The operands must fit their kinds and the target must be in reach, see [Opcode.reaches]; numbers are cut to their bytes.
 */
fun Instruction.encode(address: Int): CodeBytes = CodeBytes(InstructionEncoder(address).encode(this))

/** The instruction at [address]; null if there is none, or if the code ends within it. */
fun CodeBytes.instructionAt(address: Int): PlacedInstruction? {
    if (address !in 0 until size) return null
    val opcode = Opcode.of(this[address]) ?: return null
    if (size - address < opcode.size) return null
    return PlacedInstruction(address, InstructionDecoder(this, address).decode(opcode))
}
