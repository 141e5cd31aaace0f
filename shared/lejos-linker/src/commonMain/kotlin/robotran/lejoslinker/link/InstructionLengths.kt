package robotran.lejoslinker.link

import robotran.tinyvm.link.Opcode

/**
 * The bytes of an instruction with [opcode] and its operands; 0 for those whose length depends on their operands, and
 * for unknown ones. Source: The Java Virtual Machine Specification, chapter 6.
 */
internal fun lengthOf(opcode: Int): Int = LENGTHS[opcode]

private val LENGTHS = IntArray(256).apply {
    fill(1, 0, Opcode.TABLESWITCH)
    fill(1, Opcode.IRETURN, Opcode.WIDE)
    listOf(Opcode.BIPUSH, Opcode.LDC, Opcode.RET, Opcode.NEWARRAY).forEach { this[it] = 2 }
    fill(2, Opcode.ILOAD, Opcode.ALOAD + 1)
    fill(2, Opcode.ISTORE, Opcode.ASTORE + 1)
    listOf(Opcode.SIPUSH, Opcode.LDC_W, Opcode.LDC2_W, Opcode.IINC, Opcode.IFNULL, Opcode.IFNONNULL).forEach {
        this[it] = 3
    }
    fill(3, Opcode.IFEQ, Opcode.JSR + 1)
    fill(3, Opcode.GETSTATIC, Opcode.INVOKESTATIC + 1)
    listOf(Opcode.NEW, Opcode.ANEWARRAY, Opcode.CHECKCAST, Opcode.INSTANCEOF).forEach { this[it] = 3 }
    this[Opcode.MULTIANEWARRAY] = 4
    listOf(Opcode.INVOKEINTERFACE, Opcode.INVOKEDYNAMIC, Opcode.GOTO_W, Opcode.JSR_W).forEach { this[it] = 5 }
}
