package robotran.tinyvm.run

import robotran.tinyvm.link.Operation

/** [value] shifted by [distance] with an operation on long. */
internal fun shifted(value: Long, distance: Int, operation: Int): Long = when (operation) {
    Operation.SHIFT_LEFT_LONG -> value shl distance
    Operation.SHIFT_RIGHT_LONG -> value shr distance
    else -> value ushr distance
}

/** The result of an operation on long; the divisor of a division is not 0. */
internal fun calculated(left: Long, right: Long, operation: Int): Long = when (operation) {
    Operation.ADD_LONG -> left + right
    Operation.SUBTRACT_LONG -> left - right
    Operation.MULTIPLY_LONG -> left * right

    // The smallest long divided by -1 stops a processor of wasm.
    Operation.DIVIDE_LONG -> if (right == -1L) -left else left / right
    Operation.REMAINDER_LONG -> if (right == -1L) 0 else left % right
    Operation.AND_LONG -> left and right
    Operation.OR_LONG -> left or right
    else -> left xor right
}

/** The result of an operation on double. */
internal fun calculated(left: Double, right: Double, operation: Int): Double = when (operation) {
    Operation.ADD_DOUBLE_64 -> left + right
    Operation.SUBTRACT_DOUBLE_64 -> left - right
    Operation.MULTIPLY_DOUBLE_64 -> left * right
    Operation.DIVIDE_DOUBLE_64 -> left / right
    else -> remainder(left, right)
}

/** Puts the number at [from] of [stack], converted, at [to]; returns the words of the result. */
internal fun converted(stack: IntArray, to: Int, from: Int, operation: Int): Int {
    when (operation) {
        Operation.LONG_TO_INT -> stack[to] = stack[from]
        Operation.LONG_64_TO_FLOAT -> stack[to] = longAt(stack, from).toFloat().toBits()
        Operation.DOUBLE_64_TO_INT -> stack[to] = doubleAt(stack, from).toInt()
        Operation.DOUBLE_64_TO_FLOAT -> stack[to] = doubleAt(stack, from).toFloat().toBits()

        else -> {
            when (operation) {
                Operation.INT_TO_LONG -> setLong(stack, to, stack[from].toLong())
                Operation.INT_TO_DOUBLE_64 -> setDouble(stack, to, stack[from].toDouble())
                Operation.LONG_64_TO_DOUBLE -> setDouble(stack, to, longAt(stack, from).toDouble())
                Operation.FLOAT_TO_LONG_64 -> setLong(stack, to, Float.fromBits(stack[from]).toLong())
                Operation.FLOAT_TO_DOUBLE_64 -> setDouble(stack, to, Float.fromBits(stack[from]).toDouble())
                else -> setLong(stack, to, doubleAt(stack, from).toLong())
            }
            return 2
        }
    }
    return 1
}

/** -1, 0 or 1 as the number at [left] of [stack] is less than, equal to or greater than that at [right]. */
internal fun compared(stack: IntArray, left: Int, right: Int, operation: Int): Int {
    if (operation == Operation.COMPARE_LONG) return longAt(stack, left).compareTo(longAt(stack, right))
    val first = doubleAt(stack, left)
    val second = doubleAt(stack, right)
    return when {
        first < second -> -1
        first > second -> 1
        first == second -> 0
        operation == Operation.COMPARE_DOUBLE_64_LOW -> -1
        else -> 1
    }
}
