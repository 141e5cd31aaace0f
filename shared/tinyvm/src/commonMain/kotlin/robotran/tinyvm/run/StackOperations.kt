package robotran.tinyvm.run

import robotran.tinyvm.link.Operation

/** Rearranges the topmost operands of [stack], which end before index [top]; returns the new end. */
internal fun shuffle(stack: IntArray, top: Int, operation: Int): Int = when (operation) {
    Operation.DUPLICATE_BELOW_1 -> repeatBelow(stack, top, 1, 1)
    Operation.DUPLICATE_BELOW_2 -> repeatBelow(stack, top, 1, 2)
    Operation.DUPLICATE_2 -> repeatBelow(stack, top, 2, 0)
    Operation.DUPLICATE_2_BELOW_1 -> repeatBelow(stack, top, 2, 1)
    Operation.DUPLICATE_2_BELOW_2 -> repeatBelow(stack, top, 2, 2)

    else -> {
        val upper = stack[top - 1]
        stack[top - 1] = stack[top - 2]
        stack[top - 2] = upper
        top
    }
}

/** Inserts a copy of the topmost [count] operands below the next [below] operands. */
private fun repeatBelow(stack: IntArray, top: Int, count: Int, below: Int): Int {
    for (place in top - 1 downTo top - count - below) stack[place + count] = stack[place]
    for (index in 0 until count) stack[top - count - below + index] = stack[top + index]
    return top + count
}

/** Computes [operation], one for doubles; a brick's doubles have 32 bits. */
internal fun calculate(left: Float, right: Float, operation: Int): Float = when (operation) {
    Operation.ADD_DOUBLE -> left + right
    Operation.SUBTRACT_DOUBLE -> left - right
    Operation.MULTIPLY_DOUBLE -> left * right
    else -> left / right
}
