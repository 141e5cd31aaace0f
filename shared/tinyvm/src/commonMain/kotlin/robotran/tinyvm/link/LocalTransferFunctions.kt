package robotran.tinyvm.link

/** The effects on a [FrameState] of instructions that read or write locals. */
internal object LocalTransferFunctions {
    /** The types of the load and store instructions, in opcode order. */
    private const val KINDS = "IJFD"

    fun apply(instruction: Instruction, situation: FrameState) {
        val operand = instruction.operand
        when (instruction.opcode) {
            in Opcode.ILOAD until Opcode.ALOAD -> {
                val kind = VerificationType.ofLetter(KINDS[instruction.opcode - Opcode.ILOAD])
                if (situation.local(operand) != kind) unsound()
                if (VerificationType.isWide(kind) &&
                    situation.local(operand + 1) != VerificationType.SECOND_WORD
                ) {
                    unsound()
                }
                situation.pushValue(kind)
            }

            Opcode.ALOAD -> {
                situation.push(situation.local(operand).also { if (!VerificationType.isReference(it)) unsound() })
            }

            in Opcode.ISTORE until Opcode.ASTORE -> {
                val kind = VerificationType.ofLetter(KINDS[instruction.opcode - Opcode.ISTORE])
                situation.popValue(kind)
                situation.setLocal(operand, kind)
            }

            Opcode.ASTORE -> {
                val value = situation.pop()
                if (!VerificationType.isReference(value) && !VerificationType.isReturnAddress(value)) unsound()
                situation.setLocal(operand, value)
            }

            Opcode.IINC -> {
                if (situation.local(operand) != VerificationType.WHOLE) unsound()
            }
        }
    }
}
