package robotran.tinyvm.run

import robotran.rom.StatementWatch
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.Operation

/**
 * Executes the operations of one thread until its budget is used up, it cannot go on, or it is to pause before a statement. The verifier
 * has seen to it that no operation meets anything it cannot work on, so nothing is checked here that depends on the code alone.
 */
internal class Interpreter(private val machine: Machine, private val calls: Calls) {
    private val heap = machine.heap
    private val words = machine.heap.words
    private val statics = machine.statics
    private val methods = machine.program.methods.toTypedArray()
    private val types = machine.program.types.toTypedArray()
    private val arithmetic = QuirkyArithmetic(machine)
    private val tests = TypeTests(machine)
    private var isPassed = false

    /** Bytecodes that may still be executed. */
    var budget = 0

    /** Whether it stopped because [watch] said so. */
    var isPaused = false
        private set

    /** How many statements of the program have been begun. */
    var statementsBegun = 0L
        private set

    /** Asked before each statement once. */
    var watch: StatementWatch? = null

    /** How deep a thread is inside the program's own methods, for [watch]. */
    var depthOf: (VmThread) -> Int = { 0 }

    /** Goes on with [thread], which is ready. */
    fun run(thread: VmThread) {
        isPaused = false
        while (budget > 0 && thread.state == ThreadState.READY && !isPaused && !machine.isYielding && !machine.isExited) {
            when {
                thread.pending != 0 -> throwPending(thread)
                thread.depth == 0 -> begin(thread)
                else -> execute(thread)
            }
        }
    }

    private fun begin(thread: VmThread) {
        val main = machine.program.main
        if (thread.isMain) {
            if (calls.begin(thread, main, 0) && !machine.isReady[main.owner.number]) makeReady(thread, main.owner)
        } else {
            val run = heap.typeOf(thread.reference).virtualMethods[machine.program.threadRun.virtualIndex]
            calls.begin(thread, run, thread.reference)
        }
    }

    /** Above the frame of main, so that it is done before. */
    private fun makeReady(thread: VmThread, type: LinkedClass) {
        while (!machine.isReady[type.number] && thread.pending == 0 && thread.depth == 1) calls.initialize(thread, type)
    }

    private fun throwPending(thread: VmThread) {
        val exception = thread.pending
        thread.pending = 0
        if (thread.depth > 0) calls.throwObject(thread, exception)
    }

    private fun mayBegin(thread: VmThread, line: Int): Boolean {
        val watch = watch
        if (watch != null && !isPassed) {
            isPassed = true
            if (watch.pausesBefore(line, depthOf(thread))) return false
        }
        isPassed = false
        statementsBegun++
        return true
    }

    /** Executes operations of the innermost frame until another becomes the innermost, or the thread stops. */
    private fun execute(thread: VmThread) {
        val frame = thread.frame
        val code = frame.body.code
        val stack = thread.stack
        val words = words
        val base = frame.base
        var next = frame.next
        var top = frame.top
        var left = budget
        while (left > 0) {
            left--
            when (code[next++]) {
                Operation.STATEMENT -> {
                    left++
                    if (watch != null) {
                        frame.next = next - 1
                        frame.top = top
                        budget = left
                        if (!mayBegin(thread, code[next])) {
                            isPaused = true
                            return
                        }
                    } else {
                        isPassed = false
                        statementsBegun++
                    }
                    next++
                }
                Operation.PUSH -> stack[top++] = code[next++]
                Operation.LOAD -> stack[top++] = stack[base + code[next++]]
                Operation.STORE -> stack[base + code[next++]] = stack[--top]
                Operation.INCREMENT -> {
                    val local = base + code[next++]
                    stack[local] += code[next++]
                }
                Operation.ELEMENT -> {
                    top--
                    val place = place(stack[top - 1], stack[top])
                    if (place <= 0) {
                        frame.next = next
                        frame.top = top
                        budget = left
                        throwPlace(thread, place)
                        return
                    }
                    stack[top - 1] = words[place]
                }
                Operation.SET_ELEMENT -> {
                    top -= 3
                    val place = place(stack[top], stack[top + 1])
                    if (place <= 0) {
                        frame.next = next
                        frame.top = top
                        budget = left
                        throwPlace(thread, place)
                        return
                    }
                    words[place] = stack[top + 2]
                }
                Operation.SET_BYTE -> {
                    top -= 3
                    val place = place(stack[top], stack[top + 1])
                    if (place <= 0) {
                        frame.next = next
                        frame.top = top
                        budget = left
                        throwPlace(thread, place)
                        return
                    }
                    words[place] = stack[top + 2].toByte().toInt()
                }
                Operation.SET_CHARACTER -> {
                    top -= 3
                    val place = place(stack[top], stack[top + 1])
                    if (place <= 0) {
                        frame.next = next
                        frame.top = top
                        budget = left
                        throwPlace(thread, place)
                        return
                    }
                    words[place] = stack[top + 2] and 0xFFFF
                }
                Operation.POP -> top--
                Operation.DUPLICATE -> {
                    stack[top] = stack[top - 1]
                    top++
                }
                Operation.ADD -> {
                    top--
                    stack[top - 1] = stack[top - 1] + stack[top]
                }
                Operation.SUBTRACT -> {
                    top--
                    stack[top - 1] = stack[top - 1] - stack[top]
                }
                Operation.MULTIPLY -> {
                    top--
                    stack[top - 1] = stack[top - 1] * stack[top]
                }
                Operation.SHIFT_LEFT -> {
                    top--
                    stack[top - 1] = stack[top - 1] shl stack[top]
                }
                Operation.SHIFT_RIGHT -> {
                    top--
                    stack[top - 1] = stack[top - 1] shr stack[top]
                }
                Operation.SHIFT_RIGHT_UNSIGNED -> {
                    top--
                    stack[top - 1] = stack[top - 1] ushr stack[top]
                }
                Operation.AND -> {
                    top--
                    stack[top - 1] = stack[top - 1] and stack[top]
                }
                Operation.OR -> {
                    top--
                    stack[top - 1] = stack[top - 1] or stack[top]
                }
                Operation.XOR -> {
                    top--
                    stack[top - 1] = stack[top - 1] xor stack[top]
                }
                Operation.NEGATE -> stack[top - 1] = -stack[top - 1]
                Operation.DIVIDE -> {
                    val divisor = stack[top - 1]
                    if (divisor in 1..LARGEST_SHORT) {
                        top--
                        stack[top - 1] = stack[top - 1] / divisor
                    } else {
                        frame.next = next
                        frame.top = top
                        budget = left
                        divide(thread, frame, isRemainder = false)
                        if (thread.depth == 0 || thread.frame !== frame) return
                        next = frame.next
                        top = frame.top
                    }
                }
                Operation.REMAINDER -> {
                    val divisor = stack[top - 1]
                    if (divisor in 1..LARGEST_SHORT) {
                        top--
                        stack[top - 1] = stack[top - 1] % divisor
                    } else {
                        frame.next = next
                        frame.top = top
                        budget = left
                        divide(thread, frame, isRemainder = true)
                        if (thread.depth == 0 || thread.frame !== frame) return
                        next = frame.next
                        top = frame.top
                    }
                }
                Operation.ADD_DECIMAL -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) + Float.fromBits(stack[top])).toBits()
                }
                Operation.SUBTRACT_DECIMAL -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) - Float.fromBits(stack[top])).toBits()
                }
                Operation.MULTIPLY_DECIMAL -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) * Float.fromBits(stack[top])).toBits()
                }
                Operation.DIVIDE_DECIMAL -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) / Float.fromBits(stack[top])).toBits()
                }
                Operation.TO_BYTE -> stack[top - 1] = stack[top - 1].toByte().toInt()
                Operation.TO_DECIMAL -> stack[top - 1] = stack[top - 1].toFloat().toBits()
                Operation.IF_ZERO -> next = if (stack[--top] == 0) code[next] else next + 1
                Operation.IF_NOT_ZERO -> next = if (stack[--top] != 0) code[next] else next + 1
                Operation.IF_NEGATIVE -> next = if (stack[--top] < 0) code[next] else next + 1
                Operation.IF_NOT_NEGATIVE -> next = if (stack[--top] >= 0) code[next] else next + 1
                Operation.IF_POSITIVE -> next = if (stack[--top] > 0) code[next] else next + 1
                Operation.IF_NOT_POSITIVE -> next = if (stack[--top] <= 0) code[next] else next + 1
                Operation.IF_EQUAL -> {
                    top -= 2
                    next = if (stack[top] == stack[top + 1]) code[next] else next + 1
                }
                Operation.IF_NOT_EQUAL -> {
                    top -= 2
                    next = if (stack[top] != stack[top + 1]) code[next] else next + 1
                }
                Operation.IF_LESS -> {
                    top -= 2
                    next = if (stack[top] < stack[top + 1]) code[next] else next + 1
                }
                Operation.IF_NOT_LESS -> {
                    top -= 2
                    next = if (stack[top] >= stack[top + 1]) code[next] else next + 1
                }
                Operation.IF_GREATER -> {
                    top -= 2
                    next = if (stack[top] > stack[top + 1]) code[next] else next + 1
                }
                Operation.IF_NOT_GREATER -> {
                    top -= 2
                    next = if (stack[top] <= stack[top + 1]) code[next] else next + 1
                }
                Operation.JUMP -> next = code[next]
                Operation.STATIC -> stack[top++] = statics[code[next++]]
                Operation.SET_STATIC -> statics[code[next++]] = stack[--top]
                Operation.INITIALIZE -> {
                    left++
                    if (machine.isReady[code[next]]) {
                        next++
                    } else {
                        frame.next = next - 1
                        frame.top = top
                        budget = left
                        calls.initialize(thread, machine.program.classes[code[next]])
                        return
                    }
                }
                Operation.FIELD -> {
                    val reference = stack[top - 1]
                    if (reference == 0) {
                        frame.next = next
                        budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return
                    }
                    stack[top - 1] = words[reference + Heap.HEADER_WORDS + code[next++]]
                }
                Operation.SET_FIELD -> {
                    top -= 2
                    val reference = stack[top]
                    if (reference == 0) {
                        frame.next = next
                        budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return
                    }
                    words[reference + Heap.HEADER_WORDS + code[next++]] = stack[top + 1]
                }
                Operation.CALL_STATIC -> {
                    frame.next = next + 1
                    frame.top = top
                    budget = left
                    calls.call(thread, frame, methods[code[next]], OPERAND_AND_OPERATION)
                    return
                }
                Operation.CALL_EXACTLY -> {
                    val method = methods[code[next]]
                    frame.next = next + 1
                    frame.top = top
                    budget = left
                    if (stack[top - method.argumentWords] == 0) {
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                    } else {
                        calls.call(thread, frame, method, OPERAND_AND_OPERATION)
                    }
                    return
                }
                Operation.CALL_VIRTUAL -> {
                    val receiver = stack[top - code[next + 1]]
                    frame.next = next + 2
                    frame.top = top
                    budget = left
                    if (receiver == 0) {
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                    } else {
                        calls.call(thread, frame, types[words[receiver]].virtualMethods[code[next]], TWO_OPERANDS_AND_OPERATION)
                    }
                    return
                }
                Operation.RETURN -> {
                    frame.top = top
                    budget = left
                    calls.leave(thread, 0)
                    return
                }
                Operation.RETURN_VALUE -> {
                    frame.top = top
                    budget = left
                    calls.leave(thread, 1)
                    return
                }
                Operation.LENGTH -> {
                    val array = stack[top - 1]
                    if (array == 0) {
                        frame.next = next
                        budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return
                    }
                    stack[top - 1] = words[array + 1]
                }
                Operation.NOTHING -> Unit
                else -> {
                    frame.next = next
                    frame.top = top
                    budget = left
                    rare(thread, frame, code[next - 1])
                    if (thread.pending != 0 || thread.state != ThreadState.READY || thread.frame !== frame) return
                    next = frame.next
                    top = frame.top
                    left = budget
                }
            }
        }
        frame.next = next
        frame.top = top
        budget = left
    }

    /** An operation that is too seldom or too long for the loop; `next` of [frame] is behind the operation's own word. */
    private fun rare(thread: VmThread, frame: Frame, operation: Int) {
        val code = frame.body.code
        val stack = thread.stack
        when (operation) {
            Operation.PUSH_WIDE -> {
                stack[frame.top++] = code[frame.next++]
                stack[frame.top++] = 0
            }
            Operation.PUSH_TEXT -> push(thread, frame, machine.text(code[frame.next++]))
            Operation.LOAD_WIDE -> {
                stack[frame.top++] = stack[frame.base + code[frame.next++]]
                stack[frame.top++] = 0
            }
            Operation.STORE_WIDE -> {
                frame.top -= 2
                stack[frame.base + code[frame.next++]] = stack[frame.top]
            }
            Operation.ELEMENT_WIDE -> {
                val place = place(stack[frame.top - 2], stack[frame.top - 1])
                if (place <= 0) {
                    throwPlace(thread, place)
                } else {
                    stack[frame.top - 2] = words[place]
                    stack[frame.top - 1] = 0
                }
            }
            Operation.SET_WIDE -> {
                frame.top -= 4
                val place = place(stack[frame.top], stack[frame.top + 1])
                if (place <= 0) throwPlace(thread, place) else words[place] = stack[frame.top + 2]
            }
            Operation.SET_SHORT -> {
                frame.top -= 3
                val place = place(stack[frame.top], stack[frame.top + 1])
                if (place <= 0) throwPlace(thread, place) else words[place] = stack[frame.top + 2].toShort().toInt()
            }
            Operation.SET_REFERENCE -> storeReference(thread, frame)
            Operation.POP_2 -> frame.top -= 2
            Operation.DUPLICATE_BELOW_1, Operation.DUPLICATE_BELOW_2, Operation.DUPLICATE_2, Operation.DUPLICATE_2_BELOW_1, Operation.DUPLICATE_2_BELOW_2, Operation.SWAP -> frame.top = shuffle(stack, frame.top, operation)
            Operation.ADD_DOUBLE, Operation.SUBTRACT_DOUBLE, Operation.MULTIPLY_DOUBLE, Operation.DIVIDE_DOUBLE -> {
                frame.top -= 2
                val left = Float.fromBits(stack[frame.top - 2])
                stack[frame.top - 2] = calculate(left, Float.fromBits(stack[frame.top]), operation).toBits()
            }
            Operation.NEGATE_DECIMAL -> stack[frame.top - 1] = (-Float.fromBits(stack[frame.top - 1])).toBits()
            Operation.NEGATE_DOUBLE -> stack[frame.top - 2] = (-Float.fromBits(stack[frame.top - 2])).toBits()
            Operation.COMPARE_DECIMAL_LOW, Operation.COMPARE_DECIMAL_HIGH -> {
                frame.top--
                val withoutNumber = if (operation == Operation.COMPARE_DECIMAL_LOW) -1 else 1
                stack[frame.top - 1] = compare(Float.fromBits(stack[frame.top - 1]), Float.fromBits(stack[frame.top]), withoutNumber)
            }
            Operation.COMPARE_DOUBLE_LOW, Operation.COMPARE_DOUBLE_HIGH -> {
                frame.top -= 3
                val withoutNumber = if (operation == Operation.COMPARE_DOUBLE_LOW) -1 else 1
                stack[frame.top - 1] = compare(Float.fromBits(stack[frame.top - 1]), Float.fromBits(stack[frame.top + 1]), withoutNumber)
            }
            Operation.WIDEN -> stack[frame.top++] = 0
            Operation.NARROW -> frame.top--
            Operation.TO_WIDE_DECIMAL -> {
                stack[frame.top - 1] = stack[frame.top - 1].toFloat().toBits()
                stack[frame.top++] = 0
            }
            Operation.WIDE_TO_DECIMAL -> {
                frame.top--
                stack[frame.top - 1] = stack[frame.top - 1].toFloat().toBits()
            }
            Operation.WIDE_TO_WIDE_DECIMAL -> stack[frame.top - 2] = stack[frame.top - 2].toFloat().toBits()
            Operation.DECIMAL_TO_WHOLE -> stack[frame.top - 1] = Float.fromBits(stack[frame.top - 1]).toInt()
            Operation.DECIMAL_TO_WIDE -> {
                stack[frame.top - 1] = Float.fromBits(stack[frame.top - 1]).toInt()
                stack[frame.top++] = 0
            }
            Operation.DOUBLE_TO_WHOLE -> {
                frame.top--
                stack[frame.top - 1] = Float.fromBits(stack[frame.top - 1]).toInt()
            }
            Operation.DOUBLE_TO_WIDE -> stack[frame.top - 2] = Float.fromBits(stack[frame.top - 2]).toInt()
            Operation.TO_CHARACTER -> {
                val value = stack[frame.top - 1]
                stack[frame.top - 1] = if (value and SIXTEENTH_BIT == 0) value and 0xFFFF else arithmetic.largeCharacter(value)
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
            Operation.FIELD_WIDE -> {
                val reference = stack[frame.top - 1]
                if (reference == 0) {
                    calls.throwNew(thread, BuiltInException.NULL_POINTER)
                } else {
                    stack[frame.top - 1] = words[reference + Heap.HEADER_WORDS + code[frame.next++]]
                    stack[frame.top++] = 0
                }
            }
            Operation.SET_FIELD_WIDE -> {
                frame.top -= 3
                val reference = stack[frame.top]
                if (reference == 0) {
                    calls.throwNew(thread, BuiltInException.NULL_POINTER)
                } else {
                    words[reference + Heap.HEADER_WORDS + code[frame.next++]] = stack[frame.top + 1]
                }
            }
            Operation.CALL_INTERFACE -> {
                val receiver = stack[frame.top - code[frame.next + 1]]
                val method = if (receiver == 0) null else types[words[receiver]].interfaceMethods[code[frame.next]]
                frame.next += 2
                when {
                    receiver == 0 -> calls.throwNew(thread, BuiltInException.NULL_POINTER)
                    method == null -> calls.throwNew(thread, BuiltInException.NO_SUCH_METHOD)
                    else -> calls.call(thread, frame, method, TWO_OPERANDS_AND_OPERATION)
                }
            }
            Operation.RETURN_WIDE -> calls.leave(thread, 2)
            Operation.NEW -> push(thread, frame, machine.newObject(types[code[frame.next++]] as LinkedClass))
            Operation.NEW_ARRAY -> {
                val length = stack[--frame.top]
                push(thread, frame, machine.newArray(types[code[frame.next++]] as ArrayType, length))
            }
            Operation.NEW_ARRAYS -> {
                val type = types[code[frame.next++]] as ArrayType
                val dimensions = code[frame.next++]
                frame.top -= dimensions
                push(thread, frame, machine.newArrays(type, stack, frame.top, dimensions))
            }
            Operation.THROW -> {
                val exception = stack[--frame.top]
                if (exception == 0) calls.throwNew(thread, BuiltInException.NULL_POINTER) else calls.throwObject(thread, exception)
            }
            Operation.CAST -> {
                val reference = stack[frame.top - 1]
                if (reference != 0 && !tests.passesFor(reference, code[frame.next])) {
                    calls.throwNew(thread, BuiltInException.CLASS_CAST)
                } else {
                    frame.next++
                }
            }
            Operation.IS_INSTANCE -> {
                val reference = stack[frame.top - 1]
                stack[frame.top - 1] = if (reference != 0 && tests.passesFor(reference, code[frame.next])) 1 else 0
                frame.next++
            }
            Operation.ENTER_MONITOR -> {
                val lock = stack[frame.top - 1]
                when {
                    lock == 0 -> calls.throwNew(thread, BuiltInException.NULL_POINTER)
                    machine.monitors.enter(lock, thread) -> frame.top--
                    else -> {
                        frame.next--
                        calls.block(thread, lock)
                    }
                }
            }
            Operation.EXIT_MONITOR -> {
                val lock = stack[--frame.top]
                if (lock != 0 && !machine.monitors.exit(lock, thread)) calls.throwNew(thread, BuiltInException.ILLEGAL_MONITOR_STATE)
            }
        }
    }

    /** The place of an element, 0 if [array] is null, negative if [index] is outside. */
    private fun place(array: Int, index: Int): Int = when {
        array == 0 -> 0
        index >= 0 && index < words[array + 1] -> array + Heap.HEADER_WORDS + index
        else -> arithmetic.strangeIndex(array, index)
    }

    /** Throws what [place] stands for when it is no place. */
    private fun throwPlace(thread: VmThread, place: Int) =
        calls.throwNew(thread, if (place == 0) BuiltInException.NULL_POINTER else BuiltInException.ARRAY_INDEX)

    private fun storeReference(thread: VmThread, frame: Frame) {
        val stack = thread.stack
        frame.top -= 3
        val array = stack[frame.top]
        val value = stack[frame.top + 2]
        val place = place(array, stack[frame.top + 1])
        when {
            place <= 0 -> throwPlace(thread, place)
            value != 0 && !tests.mayStore(array, value) -> calls.throwNew(thread, BuiltInException.CLASS_CAST)
            else -> words[place] = value
        }
    }

    private fun divide(thread: VmThread, frame: Frame, isRemainder: Boolean) {
        val stack = thread.stack
        var divisor = stack[--frame.top]
        if (divisor != divisor.toShort().toInt()) divisor = arithmetic.largeDivisor(divisor)
        val dividend = stack[frame.top - 1]
        when (divisor) {
            0 -> calls.throwNew(thread, BuiltInException.ARITHMETIC)
            -1 -> stack[frame.top - 1] = if (isRemainder) 0 else -dividend
            else -> stack[frame.top - 1] = if (isRemainder) dividend % divisor else dividend / divisor
        }
    }

    private fun push(thread: VmThread, frame: Frame, reference: Int) {
        if (reference == 0) calls.throwNew(thread, BuiltInException.OUT_OF_MEMORY) else thread.stack[frame.top++] = reference
    }

    private fun compare(left: Float, right: Float, withoutNumber: Int): Int = when {
        left < right -> -1
        left > right -> 1
        left == right -> 0
        else -> arithmetic.compareWithoutNumber(withoutNumber)
    }

    private companion object {
        const val LARGEST_SHORT = 32_767
        const val SIXTEENTH_BIT = 0x8000
        const val OPERAND_AND_OPERATION = 2
        const val TWO_OPERANDS_AND_OPERATION = 3
    }
}
