package robotran.tinyvm.run

import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.ExactCosts
import robotran.tinyvm.link.Operation

/** The operations that only an exact machine has: those on long and double, `switch`, and class constants. */
internal class NxtOperations(
    private val machine: VirtualMachine,
    private val calls: Calls,
    private val places: ArrayAddressing,
) {
    private val words = machine.heap.words
    private val statics = machine.statics
    private val types = machine.program.types.toTypedArray()

    /** Executes [operation] for [thread]; its operands start at `next` of [frame]. */
    fun execute(thread: VmThread, frame: Frame, operation: Int) {
        val stack = thread.stack
        when (operation) {
            in Operation.PUSH_LONG..Operation.SET_STATIC_LONG -> move(frame, stack, operation)
            in Operation.FIELD_LONG..Operation.SET_ELEMENT_LONG -> access(thread, frame, operation)
            in Operation.ADD_LONG..Operation.XOR_LONG -> whole(thread, frame, operation)
            in Operation.REMAINDER_FLOAT..Operation.NEGATE_DOUBLE_64 -> decimal(frame, stack, operation)
            in Operation.INT_TO_LONG..Operation.DOUBLE_64_TO_FLOAT -> convert(frame, stack, operation)
            in Operation.COMPARE_LONG..Operation.COMPARE_DOUBLE_64_HIGH -> compare(frame, stack, operation)
            Operation.SWITCH -> switch(frame, stack)
            else -> pushClass(thread, frame)
        }
    }

    private fun move(frame: Frame, stack: IntArray, operation: Int) {
        val code = frame.body.code
        val operand = code[frame.next++]
        when (operation) {
            Operation.PUSH_LONG -> {
                stack[frame.top++] = operand
                stack[frame.top++] = code[frame.next++]
            }

            Operation.LOAD_LONG -> {
                stack[frame.top++] = stack[frame.base + operand]
                stack[frame.top++] = stack[frame.base + operand + 1]
            }

            Operation.STORE_LONG -> {
                frame.top -= 2
                stack[frame.base + operand] = stack[frame.top]
                stack[frame.base + operand + 1] = stack[frame.top + 1]
            }

            Operation.STATIC_LONG -> {
                stack[frame.top++] = statics[operand]
                stack[frame.top++] = statics[operand + 1]
            }

            else -> {
                frame.top -= 2
                statics[operand] = stack[frame.top]
                statics[operand + 1] = stack[frame.top + 1]
            }
        }
    }

    private fun access(thread: VmThread, frame: Frame, operation: Int) {
        val stack = thread.stack
        when (operation) {
            Operation.FIELD_LONG -> {
                val reference = stack[frame.top - 1]
                if (reference == 0) return calls.throwNew(thread, BuiltInException.NULL_POINTER)
                val place = reference + Heap.HEADER_WORDS + frame.body.code[frame.next++]
                stack[frame.top - 1] = words[place]
                stack[frame.top++] = words[place + 1]
            }

            Operation.SET_FIELD_LONG -> {
                frame.top -= 3
                val reference = stack[frame.top]
                if (reference == 0) return calls.throwNew(thread, BuiltInException.NULL_POINTER)
                val place = reference + Heap.HEADER_WORDS + frame.body.code[frame.next++]
                words[place] = stack[frame.top + 1]
                words[place + 1] = stack[frame.top + 2]
            }

            Operation.ELEMENT_LONG -> {
                val place = find(stack[frame.top - 2], stack[frame.top - 1])
                if (place <= 0) return calls.throwNew(thread, places.failure(place))
                stack[frame.top - 2] = words[place]
                stack[frame.top - 1] = words[place + 1]
            }

            else -> {
                frame.top -= 4
                val place = find(stack[frame.top], stack[frame.top + 1])
                if (place <= 0) return calls.throwNew(thread, places.failure(place))
                words[place] = stack[frame.top + 2]
                words[place + 1] = stack[frame.top + 3]
            }
        }
    }

    /** The heap index of an element of two words, 0 if [array] is null, negative if [index] is out of bounds. */
    private fun find(array: Int, index: Int): Int = when {
        array == 0 -> 0
        index >= 0 && index < words[array + 1] -> array + Heap.HEADER_WORDS + 2 * index
        else -> -1
    }

    private fun whole(thread: VmThread, frame: Frame, operation: Int) {
        val stack = thread.stack
        when (operation) {
            Operation.NEGATE_LONG -> setLong(stack, frame.top - 2, -longAt(stack, frame.top - 2))

            in Operation.SHIFT_LEFT_LONG..Operation.SHIFT_RIGHT_UNSIGNED_LONG -> {
                val distance = stack[--frame.top]
                setLong(stack, frame.top - 2, shifted(longAt(stack, frame.top - 2), distance, operation))
            }

            else -> {
                frame.top -= 2
                val right = longAt(stack, frame.top)
                val isDivision = operation == Operation.DIVIDE_LONG || operation == Operation.REMAINDER_LONG
                if (isDivision) {
                    machine.charge(NxtCosts.WHOLE_64_DIVISION)
                    if (right == 0L) return calls.throwNew(thread, BuiltInException.ARITHMETIC)
                }
                setLong(stack, frame.top - 2, calculated(longAt(stack, frame.top - 2), right, operation))
            }
        }
    }

    private fun decimal(frame: Frame, stack: IntArray, operation: Int) {
        when (operation) {
            Operation.REMAINDER_FLOAT -> {
                frame.top--
                val left = Float.fromBits(stack[frame.top - 1]).toDouble()
                val right = Float.fromBits(stack[frame.top]).toDouble()
                stack[frame.top - 1] = remainder(left, right).toFloat().toBits()
            }

            Operation.NEGATE_DOUBLE_64 -> setDouble(stack, frame.top - 2, -doubleAt(stack, frame.top - 2))

            else -> {
                frame.top -= 2
                machine.charge(ExactCosts.of(operation))
                val left = doubleAt(stack, frame.top - 2)
                setDouble(stack, frame.top - 2, calculated(left, doubleAt(stack, frame.top), operation))
            }
        }
    }

    private fun convert(frame: Frame, stack: IntArray, operation: Int) {
        val isWide = operation in Operation.LONG_TO_INT..Operation.LONG_64_TO_DOUBLE ||
            operation >= Operation.DOUBLE_64_TO_INT
        if (isWide) frame.top -= 2 else frame.top--
        frame.top += converted(stack, frame.top, frame.top, operation)
    }

    private fun compare(frame: Frame, stack: IntArray, operation: Int) {
        frame.top -= 4
        stack[frame.top] = compared(stack, frame.top, frame.top + 2, operation)
        frame.top++
    }

    private fun switch(frame: Frame, stack: IntArray) {
        val table = frame.body.switches[frame.body.code[frame.next]]
        frame.next = table.target(stack[--frame.top])
    }

    private fun pushClass(thread: VmThread, frame: Frame) {
        val reference = machine.classObject(types[frame.body.code[frame.next++]])
        if (reference == 0) return calls.throwNew(thread, BuiltInException.OUT_OF_MEMORY)
        thread.stack[frame.top++] = reference
    }
}
