package robotran.legofirmware.instructions

import robotran.legofirmware.image.CodeBytes

/** Reads the operands of the instruction at [start], all of whose bytes are in [code]. */
internal class InstructionDecoder(private val code: CodeBytes, start: Int) {
    private var position = start + 1

    fun decode(opcode: Opcode): Instruction {
        val operands = ArrayList<Operand>(opcode.operands.size)
        for (kind in opcode.operands) {
            val operand = read(kind)
            if (operand != null) operands += operand
        }
        return Instruction(opcode, operands)
    }

    private fun read(kind: OperandKind): Operand? = when (kind) {
        OperandKind.VALUE -> Operand.Value(byte(), word().toShort().toInt())
        OperandKind.BYTE_VALUE, OperandKind.PLACE -> Operand.Value(byte(), byte())
        OperandKind.TEST -> readTest()

        OperandKind.ZERO -> {
            position++
            null
        }

        else -> {
            val base = position
            val number = if (kind.size == 1) byte() else word()
            kind.jump?.let { Operand.Address(it.decode(base, number)) } ?: Operand.Number(number)
        }
    }

    private fun readTest(): Operand.Test {
        val relationAndSource = byte()
        val rightSource = byte()
        val leftArgument = word().toShort().toInt()
        return Operand.Test(
            Relation.of(relationAndSource shr RELATION_SHIFT),
            Operand.Value(relationAndSource and SOURCE_MASK, leftArgument),
            Operand.Value(rightSource, byte()),
        )
    }

    private fun byte(): Int = code[position++]

    private fun word(): Int = byte() or (byte() shl Byte.SIZE_BITS)

    companion object {
        /** Bits of a test's first byte: the relation above, the source of the first value below. */
        const val RELATION_SHIFT = 6
        private const val SOURCE_MASK = 0x3F
    }
}
