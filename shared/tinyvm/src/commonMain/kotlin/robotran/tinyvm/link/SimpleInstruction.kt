package robotran.tinyvm.link

/**
 * A bytecode that only pops numbers and pushes at most one.
 *
 * @property takes the operand types, topmost last: I int, F float, J long, D double.
 * @property gives the result type, empty for none.
 * @property constant the value it pushes, null if it computes one.
 * @property high the upper word of that value on an exact machine.
 */
internal class SimpleInstruction(
    val operation: Int,
    val takes: String,
    val gives: String,
    val constant: Int? = null,
    val high: Int = 0,
)

/** The simple bytecodes by opcode, null for others. Source: The Java Virtual Machine Specification, chapter 6. */
internal val SIMPLE_INSTRUCTIONS: Array<SimpleInstruction?> = arrayOfNulls<SimpleInstruction>(256).also { table ->
    fun add(opcode: Int, takes: String, gives: String, operation: Int) {
        table[opcode] = SimpleInstruction(operation, takes, gives)
    }

    fun constant(opcode: Int, gives: String, value: Int) {
        val operation = if (gives == "J" || gives == "D") Operation.PUSH_WIDE else Operation.PUSH
        table[opcode] = SimpleInstruction(operation, "", gives, value)
    }
    add(0, "", "", Operation.NOTHING)
    for (value in -1..5) constant(3 + value, "I", value)
    for (value in 0..1) constant(9 + value, "J", value)
    for (value in 0..2) constant(11 + value, "F", value.toFloat().toBits())
    for (value in 0..1) constant(14 + value, "D", value.toFloat().toBits())
    val whole = listOf(
        96 to Operation.ADD,
        100 to Operation.SUBTRACT,
        104 to Operation.MULTIPLY,
        108 to Operation.DIVIDE,
        112 to Operation.REMAINDER,
        120 to Operation.SHIFT_LEFT,
        122 to Operation.SHIFT_RIGHT,
        124 to Operation.SHIFT_RIGHT_UNSIGNED,
        126 to Operation.AND,
        128 to Operation.OR,
        130 to Operation.XOR,
    )
    for ((opcode, operation) in whole) add(opcode, "II", "I", operation)
    for (index in 0..3) add(98 + 4 * index, "FF", "F", Operation.ADD_FLOAT + index)
    for (index in 0..3) add(99 + 4 * index, "DD", "D", Operation.ADD_DOUBLE + index)
    add(116, "I", "I", Operation.NEGATE)
    add(118, "F", "F", Operation.NEGATE_FLOAT)
    add(119, "D", "D", Operation.NEGATE_DOUBLE)
    add(133, "I", "J", Operation.WIDEN)
    add(134, "I", "F", Operation.INT_TO_FLOAT)
    add(135, "I", "D", Operation.INT_TO_DOUBLE)
    add(136, "J", "I", Operation.NARROW)
    add(137, "J", "F", Operation.LONG_TO_FLOAT)
    add(138, "J", "D", Operation.LONG_TO_DOUBLE)
    add(139, "F", "I", Operation.FLOAT_TO_INT)
    add(140, "F", "J", Operation.FLOAT_TO_LONG)
    add(141, "F", "D", Operation.WIDEN)
    add(142, "D", "I", Operation.DOUBLE_TO_INT)
    add(143, "D", "J", Operation.DOUBLE_TO_LONG)
    add(144, "D", "F", Operation.NARROW)
    add(145, "I", "I", Operation.TO_BYTE)
    add(146, "I", "I", Operation.TO_CHARACTER)
    add(147, "I", "I", Operation.TO_SHORT)
    for (index in 0..1) add(149 + index, "FF", "I", Operation.COMPARE_FLOAT_LOW + index)
    for (index in 0..1) add(151 + index, "DD", "I", Operation.COMPARE_DOUBLE_LOW + index)
}
