package robotran.tinyvm.link

/**
 * [SIMPLE_INSTRUCTIONS] for an exact machine: long and double have 64 bits, and all bytecodes that calculate are there.
 * Source: The Java Virtual Machine Specification, chapter 6.
 */
internal val EXACT_INSTRUCTIONS: Array<SimpleInstruction?> = SIMPLE_INSTRUCTIONS.copyOf().also { table ->
    fun add(opcode: Int, takes: String, gives: String, operation: Int) {
        table[opcode] = SimpleInstruction(operation, takes, gives)
    }

    fun constant(opcode: Int, gives: String, value: Long) {
        val high = (value shr Int.SIZE_BITS).toInt()
        table[opcode] = SimpleInstruction(Operation.PUSH_LONG, "", gives, value.toInt(), high)
    }
    for (value in 0..1) constant(9 + value, "J", value.toLong())
    for (value in 0..1) constant(14 + value, "D", value.toDouble().toBits())
    for (index in 0..4) add(97 + 4 * index, "JJ", "J", Operation.ADD_LONG + index)
    for (index in 0..4) add(99 + 4 * index, "DD", "D", Operation.ADD_DOUBLE_64 + index)
    add(114, "FF", "F", Operation.REMAINDER_FLOAT)
    add(117, "J", "J", Operation.NEGATE_LONG)
    add(119, "D", "D", Operation.NEGATE_DOUBLE_64)
    for (index in 0..2) add(121 + 2 * index, "JI", "J", Operation.SHIFT_LEFT_LONG + index)
    for (index in 0..2) add(127 + 2 * index, "JJ", "J", Operation.AND_LONG + index)
    add(133, "I", "J", Operation.INT_TO_LONG)
    add(135, "I", "D", Operation.INT_TO_DOUBLE_64)
    add(136, "J", "I", Operation.LONG_TO_INT)
    add(137, "J", "F", Operation.LONG_64_TO_FLOAT)
    add(138, "J", "D", Operation.LONG_64_TO_DOUBLE)
    add(140, "F", "J", Operation.FLOAT_TO_LONG_64)
    add(141, "F", "D", Operation.FLOAT_TO_DOUBLE_64)
    add(142, "D", "I", Operation.DOUBLE_64_TO_INT)
    add(143, "D", "J", Operation.DOUBLE_64_TO_LONG)
    add(144, "D", "F", Operation.DOUBLE_64_TO_FLOAT)
    add(148, "JJ", "I", Operation.COMPARE_LONG)
    for (index in 0..1) add(151 + index, "DD", "I", Operation.COMPARE_DOUBLE_64_LOW + index)
}

/** The simple bytecodes of an exact machine or of an RCX. */
internal fun simpleInstructions(isExact: Boolean): Array<SimpleInstruction?> =
    if (isExact) EXACT_INSTRUCTIONS else SIMPLE_INSTRUCTIONS
