package robotran.tinyvm.run

import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.Operation
import robotran.tinyvm.link.RegisterOperation

/**
 * The instructions of register code that a program for an RCX has seldom or never and that do not call. They are not in
 * the interpreter's loop, which would become too large to be compiled well.
 */
internal class WideOperations(private val machine: VirtualMachine) {
    private val words = machine.heap.words
    private val statics = machine.statics
    private val types = machine.program.types.toTypedArray()

    /** By type and then by other type, whether the first is one of the second: 0 if it is not known yet. */
    private val relations = arrayOfNulls<ByteArray>(types.size)

    /**
     * Executes the instruction at [at] of [code], which belongs to [frame] and has its registers in [stack]; returns the
     * place of the last word before the next instruction, or -1 if the stack code must do it.
     */
    fun execute(frame: Frame, code: IntArray, at: Int, stack: IntArray): Int {
        val base = frame.base
        val word = code[at]
        val a = base + (word ushr SHIFT_A and BYTE)
        val b = base + (word ushr SHIFT_B and BYTE)
        val c = base + (word ushr SHIFT_C)
        when (word and BYTE) {
            RegisterOperation.ADD_LONG -> setLong(stack, a, longAt(stack, b) + longAt(stack, c))
            RegisterOperation.SUBTRACT_LONG -> setLong(stack, a, longAt(stack, b) - longAt(stack, c))
            RegisterOperation.MULTIPLY_LONG -> setLong(stack, a, longAt(stack, b) * longAt(stack, c))

            RegisterOperation.DIVIDE_LONG -> {
                val divisor = longAt(stack, c)
                if (divisor == 0L) return -1
                setLong(stack, a, if (divisor == -1L) -longAt(stack, b) else longAt(stack, b) / divisor)
            }

            RegisterOperation.REMAINDER_LONG -> {
                val divisor = longAt(stack, c)
                if (divisor == 0L) return -1
                setLong(stack, a, if (divisor == -1L) 0 else longAt(stack, b) % divisor)
            }

            RegisterOperation.NEGATE_LONG -> setLong(stack, a, -longAt(stack, b))
            RegisterOperation.SHIFT_LEFT_LONG -> setLong(stack, a, longAt(stack, b) shl stack[c])
            RegisterOperation.SHIFT_RIGHT_LONG -> setLong(stack, a, longAt(stack, b) shr stack[c])
            RegisterOperation.SHIFT_RIGHT_UNSIGNED_LONG -> setLong(stack, a, longAt(stack, b) ushr stack[c])
            RegisterOperation.AND_LONG -> setLong(stack, a, longAt(stack, b) and longAt(stack, c))
            RegisterOperation.OR_LONG -> setLong(stack, a, longAt(stack, b) or longAt(stack, c))
            RegisterOperation.XOR_LONG -> setLong(stack, a, longAt(stack, b) xor longAt(stack, c))
            RegisterOperation.ADD_DOUBLE -> setDouble(stack, a, doubleAt(stack, b) + doubleAt(stack, c))
            RegisterOperation.SUBTRACT_DOUBLE -> setDouble(stack, a, doubleAt(stack, b) - doubleAt(stack, c))
            RegisterOperation.MULTIPLY_DOUBLE -> setDouble(stack, a, doubleAt(stack, b) * doubleAt(stack, c))
            RegisterOperation.DIVIDE_DOUBLE -> setDouble(stack, a, doubleAt(stack, b) / doubleAt(stack, c))
            RegisterOperation.NEGATE_DOUBLE -> setDouble(stack, a, -doubleAt(stack, b))
            RegisterOperation.INT_TO_DOUBLE -> setDouble(stack, a, stack[b].toDouble())
            RegisterOperation.FLOAT_TO_DOUBLE -> setDouble(stack, a, Float.fromBits(stack[b]).toDouble())
            RegisterOperation.DOUBLE_TO_INT -> stack[a] = doubleAt(stack, b).toInt()
            RegisterOperation.DOUBLE_TO_FLOAT -> stack[a] = doubleAt(stack, b).toFloat().toBits()
            RegisterOperation.COMPARE_LONG -> stack[a] = longAt(stack, b).compareTo(longAt(stack, c))
            RegisterOperation.COMPARE_DOUBLE_LOW -> stack[a] = compared(stack, b, c, Operation.COMPARE_DOUBLE_64_LOW)
            RegisterOperation.COMPARE_DOUBLE_HIGH -> stack[a] = compared(stack, b, c, Operation.COMPARE_DOUBLE_64_HIGH)

            RegisterOperation.FIELD_LONG -> {
                val reference = stack[b]
                if (reference == 0) return -1
                val place = reference + Heap.HEADER_WORDS + (word ushr SHIFT_C)
                stack[a] = words[place]
                stack[a + 1] = words[place + 1]
            }

            RegisterOperation.SET_FIELD_LONG -> {
                val reference = stack[a]
                if (reference == 0) return -1
                val place = reference + Heap.HEADER_WORDS + (word ushr SHIFT_B and BYTE)
                words[place] = stack[c]
                words[place + 1] = stack[c + 1]
            }

            RegisterOperation.ELEMENT_LONG -> {
                val array = stack[b]
                val index = stack[c]
                if (array == 0 || index < 0 || index >= words[array + 1]) return -1
                val place = array + Heap.HEADER_WORDS + 2 * index
                stack[a] = words[place]
                stack[a + 1] = words[place + 1]
            }

            RegisterOperation.SET_ELEMENT_LONG -> {
                val array = stack[a]
                val index = stack[b]
                if (array == 0 || index < 0 || index >= words[array + 1]) return -1
                val place = array + Heap.HEADER_WORDS + 2 * index
                words[place] = stack[c]
                words[place + 1] = stack[c + 1]
            }

            RegisterOperation.STATIC_FAR -> {
                stack[a] = statics[code[at + 1]]
                return at + 1
            }

            RegisterOperation.SET_STATIC_FAR -> {
                statics[code[at + 1]] = stack[a]
                return at + 1
            }

            RegisterOperation.SWITCH -> return at + 1 + JUMP_WORDS * frame.body.switches[code[at + 1]].indexOf(stack[a])

            RegisterOperation.STATIC_LONG -> {
                val slot = code[at + 1]
                stack[a] = statics[slot]
                stack[a + 1] = statics[slot + 1]
                return at + 1
            }

            RegisterOperation.SET_STATIC_LONG -> {
                val slot = code[at + 1]
                statics[slot] = stack[a]
                statics[slot + 1] = stack[a + 1]
                return at + 1
            }

            RegisterOperation.CAST -> {
                val reference = stack[a]
                if (reference != 0 && !isA(words[reference], code[at + 1])) return -1
                return at + 1
            }

            RegisterOperation.IS_INSTANCE -> {
                val reference = stack[b]
                stack[a] = if (reference != 0 && isA(words[reference], code[at + 1])) 1 else 0
                return at + 1
            }

            RegisterOperation.SET_REFERENCE -> {
                val array = stack[a]
                val index = stack[b]
                val value = stack[c]
                if (array == 0 || index < 0 || index >= words[array + 1]) return -1
                if (value != 0) {
                    val element = (types[words[array]] as ArrayType).element ?: return -1
                    if (!isA(words[value], element.id)) return -1
                }
                words[array + Heap.HEADER_WORDS + index] = value
            }

            else -> rare(word and BYTE, a, b, c, stack)
        }
        return at
    }

    private fun rare(operation: Int, a: Int, b: Int, c: Int, stack: IntArray) {
        when (operation) {
            RegisterOperation.REMAINDER_DOUBLE -> setDouble(stack, a, remainder(doubleAt(stack, b), doubleAt(stack, c)))

            RegisterOperation.REMAINDER_FLOAT -> {
                val left = Float.fromBits(stack[b]).toDouble()
                stack[a] = remainder(left, Float.fromBits(stack[c]).toDouble()).toFloat().toBits()
            }

            else -> converted(stack, a, b, Operation.ADD_LONG + operation - RegisterOperation.ADD_LONG)
        }
    }

    /** Whether the type with the id [type] is one of [other]. */
    private fun isA(type: Int, other: Int): Boolean {
        if (type == other) return true
        val known = relations[type] ?: ByteArray(types.size).also { relations[type] = it }
        if (known[other] == UNKNOWN) known[other] = if (types[type].isA(types[other])) YES else NO
        return known[other] == YES
    }

    private companion object {
        const val BYTE = 0xFF
        const val SHIFT_A = 8
        const val SHIFT_B = 16
        const val SHIFT_C = 24

        /** Words of a jump. */
        const val JUMP_WORDS = 2
        const val UNKNOWN: Byte = 0
        const val YES: Byte = 1
        const val NO: Byte = 2
    }
}
