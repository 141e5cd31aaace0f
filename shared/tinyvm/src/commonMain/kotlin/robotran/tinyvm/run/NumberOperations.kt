package robotran.tinyvm.run

import robotran.tinyvm.link.Operation

/** Number and stack operations that are too rare for the interpreter's loop. None of them throws. */
internal class NumberOperations(machine: VirtualMachine, private val arithmetic: RcxArithmetic) {
    private val statics = machine.statics

    /** Executes [operation], whose operands start at `next` of [frame]; returns false if it is not one of these. */
    fun execute(frame: Frame, stack: IntArray, operation: Int): Boolean {
        val code = frame.body.code
        when (operation) {
            Operation.PUSH_WIDE -> {
                stack[frame.top++] = code[frame.next++]
                stack[frame.top++] = 0
            }

            Operation.LOAD_WIDE -> {
                stack[frame.top++] = stack[frame.base + code[frame.next++]]
                stack[frame.top++] = 0
            }

            Operation.STORE_WIDE -> {
                frame.top -= 2
                stack[frame.base + code[frame.next++]] = stack[frame.top]
            }

            Operation.POP_2 -> frame.top -= 2
            in Operation.DUPLICATE_BELOW_1..Operation.SWAP -> frame.top = shuffle(stack, frame.top, operation)

            Operation.ADD_DOUBLE, Operation.SUBTRACT_DOUBLE, Operation.MULTIPLY_DOUBLE, Operation.DIVIDE_DOUBLE -> {
                frame.top -= 2
                val left = Float.fromBits(stack[frame.top - 2])
                stack[frame.top - 2] = calculate(left, Float.fromBits(stack[frame.top]), operation).toBits()
            }

            Operation.NEGATE_FLOAT -> stack[frame.top - 1] = (-Float.fromBits(stack[frame.top - 1])).toBits()
            Operation.NEGATE_DOUBLE -> stack[frame.top - 2] = (-Float.fromBits(stack[frame.top - 2])).toBits()

            Operation.COMPARE_FLOAT_LOW, Operation.COMPARE_FLOAT_HIGH -> {
                frame.top--
                val nanResult = if (operation == Operation.COMPARE_FLOAT_LOW) -1 else 1
                stack[frame.top - 1] =
                    compare(Float.fromBits(stack[frame.top - 1]), Float.fromBits(stack[frame.top]), nanResult)
            }

            Operation.COMPARE_DOUBLE_LOW, Operation.COMPARE_DOUBLE_HIGH -> {
                frame.top -= 3
                val nanResult = if (operation == Operation.COMPARE_DOUBLE_LOW) -1 else 1
                stack[frame.top - 1] =
                    compare(Float.fromBits(stack[frame.top - 1]), Float.fromBits(stack[frame.top + 1]), nanResult)
            }

            Operation.WIDEN -> stack[frame.top++] = 0
            Operation.NARROW -> frame.top--

            Operation.INT_TO_DOUBLE -> {
                stack[frame.top - 1] = stack[frame.top - 1].toFloat().toBits()
                stack[frame.top++] = 0
            }

            Operation.LONG_TO_FLOAT -> {
                frame.top--
                stack[frame.top - 1] = arithmetic.decimalOf(stack[frame.top - 1]).toBits()
            }

            Operation.LONG_TO_DOUBLE -> stack[frame.top - 2] = arithmetic.decimalOf(stack[frame.top - 2]).toBits()
            Operation.FLOAT_TO_INT -> stack[frame.top - 1] = Float.fromBits(stack[frame.top - 1]).toInt()

            Operation.FLOAT_TO_LONG -> {
                stack[frame.top - 1] = Float.fromBits(stack[frame.top - 1]).toInt()
                stack[frame.top++] = 0
            }

            Operation.DOUBLE_TO_INT -> {
                frame.top--
                stack[frame.top - 1] = Float.fromBits(stack[frame.top - 1]).toInt()
            }

            Operation.DOUBLE_TO_LONG -> stack[frame.top - 2] = Float.fromBits(stack[frame.top - 2]).toInt()

            Operation.TO_CHARACTER -> {
                val value = stack[frame.top - 1]
                stack[frame.top - 1] =
                    if (value and SIXTEENTH_BIT == 0) value and 0xFFFF else arithmetic.largeCharacter(value)
            }

            Operation.TO_SHORT -> stack[frame.top - 1] = stack[frame.top - 1].toShort().toInt()

            Operation.SUBROUTINE -> {
                stack[frame.top++] = frame.next + 1
                frame.next = code[frame.next]
            }

            Operation.END_SUBROUTINE -> frame.next = stack[frame.base + code[frame.next]]

            Operation.STATIC_WIDE -> {
                stack[frame.top++] = statics[code[frame.next++]]
                stack[frame.top++] = 0
            }

            Operation.SET_STATIC_WIDE -> {
                frame.top -= 2
                statics[code[frame.next++]] = stack[frame.top]
            }

            else -> return false
        }
        return true
    }

    private fun compare(left: Float, right: Float, nanResult: Int): Int = when {
        left < right -> -1
        left > right -> 1
        left == right -> 0
        else -> arithmetic.compareWithNaN(nanResult)
    }

    private companion object {
        const val SIXTEENTH_BIT = 0x8000
    }
}
