package robotran.tinyvm.run

import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.Operation

/**
 * Executes the code of one thread, one operation after the other. The verifier has checked everything that depends
 * on the code alone, so it is not checked here.
 */
internal class CodeInterpreter(
    private val machine: VirtualMachine,
    private val calls: Calls,
    private val gate: StatementGate,
) {
    private val rare = SlowPathOperations(machine, calls)
    private val words = machine.heap.words
    private val statics = machine.statics
    private val methods = machine.program.methods.toTypedArray()
    private val types = machine.program.types.toTypedArray()
    private val places = rare.places
    private val division = rare.division

    /**
     * Executes operations of the innermost frame of [thread], and of those that it calls and returns to, until the
     * budget is used up or something rare happens. Returns true if the debugger pauses the thread before a statement.
     */
    fun execute(thread: VmThread): Boolean {
        val words = words
        var frame = thread.frame
        var code = frame.body.code
        var stack = thread.stack
        var base = frame.base
        var next = frame.next
        var top = frame.top
        var left = machine.budget
        while (left > 0) {
            left--
            when (code[next++]) {
                Operation.STATEMENT -> {
                    left++
                    if (gate.isWatched) {
                        frame.next = next - 1
                        frame.top = top
                        machine.budget = left
                        if (!gate.mayBegin(thread, code[next])) {
                            return true
                        }
                    } else {
                        gate.begin()
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
                    frame.next = next
                    top--
                    val place = places.find(stack[top - 1], stack[top])
                    if (place <= 0) {
                        frame.top = top
                        machine.budget = left
                        calls.throwNew(thread, places.failure(place))
                        return false
                    }
                    stack[top - 1] = words[place]
                }

                Operation.SET_ELEMENT -> {
                    frame.next = next
                    top -= 3
                    val place = places.find(stack[top], stack[top + 1])
                    if (place <= 0) {
                        frame.top = top
                        machine.budget = left
                        calls.throwNew(thread, places.failure(place))
                        return false
                    }
                    words[place] = stack[top + 2]
                }

                Operation.SET_BYTE -> {
                    frame.next = next
                    top -= 3
                    val place = places.find(stack[top], stack[top + 1])
                    if (place <= 0) {
                        frame.top = top
                        machine.budget = left
                        calls.throwNew(thread, places.failure(place))
                        return false
                    }
                    words[place] = stack[top + 2].toByte().toInt()
                }

                Operation.SET_CHARACTER -> {
                    frame.next = next
                    top -= 3
                    val place = places.find(stack[top], stack[top + 1])
                    if (place <= 0) {
                        frame.top = top
                        machine.budget = left
                        calls.throwNew(thread, places.failure(place))
                        return false
                    }
                    words[place] = places.storedCharacter(stack[top + 2])
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
                    if (divisor in 1..MAX_SHORT) {
                        top--
                        stack[top - 1] = stack[top - 1] / divisor
                    } else {
                        frame.next = next
                        frame.top = top
                        machine.budget = left
                        division.execute(thread, frame, isRemainder = false)
                        if (thread.depth == 0 || thread.frame !== frame) return false
                        next = frame.next
                        top = frame.top
                        left = machine.budget
                    }
                }

                Operation.REMAINDER -> {
                    val divisor = stack[top - 1]
                    if (divisor in 1..MAX_SHORT) {
                        top--
                        stack[top - 1] = stack[top - 1] % divisor
                    } else {
                        frame.next = next
                        frame.top = top
                        machine.budget = left
                        division.execute(thread, frame, isRemainder = true)
                        if (thread.depth == 0 || thread.frame !== frame) return false
                        next = frame.next
                        top = frame.top
                        left = machine.budget
                    }
                }

                Operation.ADD_FLOAT -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) + Float.fromBits(stack[top])).toBits()
                }

                Operation.SUBTRACT_FLOAT -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) - Float.fromBits(stack[top])).toBits()
                }

                Operation.MULTIPLY_FLOAT -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) * Float.fromBits(stack[top])).toBits()
                }

                Operation.DIVIDE_FLOAT -> {
                    top--
                    stack[top - 1] = (Float.fromBits(stack[top - 1]) / Float.fromBits(stack[top])).toBits()
                }

                Operation.TO_BYTE -> stack[top - 1] = stack[top - 1].toByte().toInt()
                Operation.INT_TO_FLOAT -> stack[top - 1] = stack[top - 1].toFloat().toBits()
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
                    if (machine.isInitialized[code[next]]) {
                        next++
                    } else {
                        frame.next = next - 1
                        frame.top = top
                        machine.budget = left
                        calls.initialize(thread, machine.program.classes[code[next]])
                        return false
                    }
                }

                Operation.FIELD -> {
                    val reference = stack[top - 1]
                    if (reference == 0) {
                        frame.next = next
                        machine.budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return false
                    }
                    stack[top - 1] = words[reference + Heap.HEADER_WORDS + code[next++]]
                }

                Operation.SET_FIELD -> {
                    top -= 2
                    val reference = stack[top]
                    if (reference == 0) {
                        frame.next = next
                        machine.budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return false
                    }
                    words[reference + Heap.HEADER_WORDS + code[next++]] = stack[top + 1]
                }

                Operation.CALL_STATIC -> {
                    val method = methods[code[next]]
                    val body = if (method.isSynchronized) null else method.body
                    val called = if (body == null) null else thread.push(top - method.argumentWords, method.frameWords)
                    frame.next = next + 1
                    if (body == null || called == null) {
                        frame.top = top
                        machine.budget = left
                        calls.call(thread, frame, method, OPERAND_AND_OPERATION, isVirtual = false)
                        return false
                    }
                    base = top - method.argumentWords
                    frame.top = base
                    called.begin(method, base, thread.stack)
                    frame = called
                    code = body.code
                    stack = thread.stack
                    next = 0
                    top = called.top
                }

                Operation.CALL_EXACTLY -> {
                    val method = methods[code[next]]
                    val isNull = stack[top - method.argumentWords] == 0
                    val body = if (isNull || method.isSynchronized) null else method.body
                    val called = if (body == null) null else thread.push(top - method.argumentWords, method.frameWords)
                    frame.next = next + 1
                    if (body == null || called == null) {
                        frame.top = top
                        machine.budget = left
                        if (isNull) {
                            calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        } else {
                            calls.call(thread, frame, method, OPERAND_AND_OPERATION, isVirtual = false)
                        }
                        return false
                    }
                    base = top - method.argumentWords
                    frame.top = base
                    called.begin(method, base, thread.stack)
                    frame = called
                    code = body.code
                    stack = thread.stack
                    next = 0
                    top = called.top
                }

                Operation.CALL_VIRTUAL -> {
                    val receiver = stack[top - code[next + 1]]
                    val method = if (receiver == 0) null else types[words[receiver]].virtualMethods[code[next]]
                    val body = if (method == null || method.isSynchronized) null else method.body
                    val called =
                        if (method == null ||
                            body == null
                        ) {
                            null
                        } else {
                            thread.push(top - code[next + 1], method.frameWords)
                        }
                    frame.next = next + 2
                    if (method == null) {
                        frame.top = top
                        machine.budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return false
                    }
                    if (body == null || called == null) {
                        frame.top = top
                        machine.budget = left
                        calls.call(thread, frame, method, TWO_OPERANDS_AND_OPERATION, isVirtual = true)
                        return false
                    }
                    base = top - code[next + 1]
                    frame.top = base
                    called.begin(method, base, thread.stack)
                    frame = called
                    code = body.code
                    stack = thread.stack
                    next = 0
                    top = called.top
                }

                Operation.RETURN -> {
                    if (frame.lock != 0 || thread.depth == 1) {
                        frame.top = top
                        machine.budget = left
                        calls.leave(thread, 0)
                        return false
                    }
                    thread.pop()
                    frame = thread.frame
                    code = frame.body.code
                    base = frame.base
                    next = frame.next
                    top = frame.top
                }

                Operation.RETURN_VALUE -> {
                    if (frame.lock != 0 || thread.depth == 1) {
                        frame.top = top
                        machine.budget = left
                        calls.leave(thread, 1)
                        return false
                    }
                    val value = stack[top - 1]
                    thread.pop()
                    frame = thread.frame
                    code = frame.body.code
                    base = frame.base
                    next = frame.next
                    top = frame.top
                    stack[top++] = value
                }

                Operation.LENGTH -> {
                    val array = stack[top - 1]
                    if (array == 0) {
                        frame.next = next
                        machine.budget = left
                        calls.throwNew(thread, BuiltInException.NULL_POINTER)
                        return false
                    }
                    stack[top - 1] = words[array + 1]
                }

                Operation.NOTHING -> {}

                else -> {
                    frame.next = next
                    frame.top = top
                    machine.budget = left
                    rare.execute(thread, frame, code[next - 1])
                    if (thread.pending != 0 || thread.state != ThreadState.READY || thread.frame !== frame) return false
                    next = frame.next
                    top = frame.top
                    left = machine.budget
                }
            }
        }
        frame.next = next
        frame.top = top
        machine.budget = left
        return false
    }

    private companion object {
        const val MAX_SHORT = 32_767
        const val OPERAND_AND_OPERATION = 2
        const val TWO_OPERANDS_AND_OPERATION = 3
    }
}
