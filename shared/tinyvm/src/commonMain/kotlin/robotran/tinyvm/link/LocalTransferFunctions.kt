package robotran.tinyvm.link

/** The effects on a [FrameState] of instructions that read or write locals. */
internal object LocalTransferFunctions {
    /** The types of the load and store instructions, in opcode order. */
    private const val KINDS = "IJFD"

    fun apply(instruction: Instruction, frameState: FrameState) {
        val operand = instruction.operand
        when (instruction.opcode) {
            in Opcode.ILOAD until Opcode.ALOAD -> {
                val kind = VerificationType.ofLetter(KINDS[instruction.opcode - Opcode.ILOAD])
                if (frameState.local(operand) != kind) unsound()
                if (VerificationType.isWide(kind) && frameState.local(operand + 1) != VerificationType.SECOND_WORD) {
                    unsound()
                }
                frameState.pushValue(kind)
            }

            Opcode.ALOAD -> {
                frameState.push(frameState.local(operand).also { if (!VerificationType.isReference(it)) unsound() })
            }

            in Opcode.ISTORE until Opcode.ASTORE -> {
                val kind = VerificationType.ofLetter(KINDS[instruction.opcode - Opcode.ISTORE])
                frameState.popValue(kind)
                frameState.setLocal(operand, kind)
            }

            Opcode.ASTORE -> {
                val value = frameState.pop()
                if (!VerificationType.isReference(value) && !VerificationType.isReturnAddress(value)) unsound()
                frameState.setLocal(operand, value)
            }

            Opcode.IINC -> if (frameState.local(operand) != VerificationType.INT) unsound()
        }
    }
}
