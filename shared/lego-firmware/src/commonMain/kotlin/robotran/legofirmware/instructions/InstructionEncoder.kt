package robotran.legofirmware.instructions

/** Makes the bytes of an instruction at [address]. */
internal class InstructionEncoder(private val address: Int) {
    private lateinit var bytes: ByteArray
    private var length = 0

    fun encode(instruction: Instruction): ByteArray {
        val opcode = instruction.opcode
        bytes = ByteArray(opcode.size)
        byte(opcode.code)
        val operands = instruction.operands.iterator()
        for (kind in opcode.operands) if (kind == OperandKind.ZERO) byte(0) else write(kind, operands.next())
        require(!operands.hasNext()) { "$opcode has too many operands." }
        return bytes
    }

    private fun write(kind: OperandKind, operand: Operand) = when (operand) {
        is Operand.Value -> writeValue(kind, operand)

        is Operand.Test -> {
            require(kind == OperandKind.TEST) { "$kind is no test." }
            writeTest(operand)
        }

        is Operand.Number -> {
            require(kind.jump == null && kind !in VALUES && kind != OperandKind.TEST) { "$kind is no number." }
            number(operand.value, kind.size)
        }

        is Operand.Address -> {
            val form = requireNotNull(kind.jump) { "$kind is no address." }
            number(form.encode(address + length, operand.address), kind.size)
        }
    }

    private fun writeValue(kind: OperandKind, value: Operand.Value) {
        require(kind in VALUES) { "$kind is no value." }
        byte(value.source)
        number(value.argument, kind.size - 1)
    }

    private fun writeTest(test: Operand.Test) {
        byte(test.relation.code shl InstructionDecoder.RELATION_SHIFT or test.left.source)
        byte(test.right.source)
        number(test.left.argument, 2)
        byte(test.right.argument)
    }

    private fun number(value: Int, size: Int) {
        byte(value)
        if (size == 2) byte(value shr Byte.SIZE_BITS)
    }

    private fun byte(value: Int) {
        bytes[length++] = value.toByte()
    }

    private companion object {
        val VALUES = setOf(OperandKind.VALUE, OperandKind.BYTE_VALUE, OperandKind.PLACE)
    }
}
