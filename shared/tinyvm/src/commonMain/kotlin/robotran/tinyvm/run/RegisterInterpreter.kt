package robotran.tinyvm.run

import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.RegisterCode
import robotran.tinyvm.link.RegisterOperation

/**
 * Executes the [RegisterCode] of one thread. It charges the bytecodes of a whole block before it, so it does not begin
 * one that exceeds the budget, and exits to the stack code before any instruction that would throw or do something else
 * that is rare.
 */
internal class RegisterInterpreter(
    private val machine: VirtualMachine,
    private val calls: Calls,
    private val gate: StatementGate,
    private val rare: RareOperations,
) {
    /** Why the interpreter returns. */
    enum class Result {
        /** Something has changed that may keep the thread from continuing. */
        CONTINUE,

        /** The next operation must be executed as stack code. */
        NEEDS_STACK_CODE,

        /** The budget is smaller than the next block. */
        NEEDS_BUDGET,
    }

    private val words = machine.heap.words
    private val statics = machine.statics
    private val isInitialized = machine.isInitialized
    private val methods = machine.program.methods.toTypedArray()
    private val far = FarCalls(machine)
    private val wide = WideOperations(machine)

    /** The code to execute for a call of each method, null if the call is not as simple. */
    private val callable = Array(methods.size) { number ->
        methods[number].takeIf { !it.isSynchronized }?.body?.registerCode
    }

    /** The numbers of the methods to call by type and virtual index. */
    private val virtualMethods = Array(machine.program.types.size) { id ->
        val virtual = machine.program.types[id].virtualMethods
        IntArray(virtual.size) { virtual[it].number }
    }

    /** Executes the innermost frame of [thread], which has register code, and those that it calls and returns to. */
    fun execute(thread: VmThread): Result {
        val words = words
        val statics = statics
        var frame = thread.frame
        var registers = frame.body.registerCode ?: return Result.NEEDS_STACK_CODE
        var at = registers.entries[frame.next]
        if (at < 0) return Result.NEEDS_STACK_CODE
        var code = registers.code
        var stack = thread.stack
        var base = frame.base
        var left = machine.budget
        var begun = 0
        var number: Int
        blocks@ while (true) {
            val header = code[at]
            left -= header and LOW_HALF
            if (left < 0) {
                exit(frame, registers, at, stack, left, begun)
                return Result.NEEDS_BUDGET
            }
            begun += header ushr HALF_BITS
            at++
            while (true) {
                val word = code[at]
                val a = base + (word ushr SHIFT_A and BYTE)
                val b = base + (word ushr SHIFT_B and BYTE)
                val c = base + (word ushr SHIFT_C)
                when (word and BYTE) {
                    RegisterOperation.JUMP -> {
                        at = code[at + 1]
                        continue@blocks
                    }

                    RegisterOperation.MOVE -> stack[a] = stack[b]

                    RegisterOperation.MOVE_2 -> {
                        stack[a] = stack[b]
                        stack[a + 1] = stack[c]
                    }

                    RegisterOperation.CONSTANT -> stack[a] = word shr HALF_BITS
                    RegisterOperation.WIDE_CONSTANT -> stack[a] = code[++at]
                    RegisterOperation.ADD -> stack[a] = stack[b] + stack[c]
                    RegisterOperation.SUBTRACT -> stack[a] = stack[b] - stack[c]
                    RegisterOperation.MULTIPLY -> stack[a] = stack[b] * stack[c]

                    RegisterOperation.DIVIDE -> {
                        val divisor = stack[c]
                        if (divisor !in 1..MAX_SHORT) break@blocks
                        stack[a] = stack[b] / divisor
                    }

                    RegisterOperation.REMAINDER -> {
                        val divisor = stack[c]
                        if (divisor !in 1..MAX_SHORT) break@blocks
                        stack[a] = stack[b] % divisor
                    }

                    RegisterOperation.SHIFT_LEFT -> stack[a] = stack[b] shl stack[c]
                    RegisterOperation.SHIFT_RIGHT -> stack[a] = stack[b] shr stack[c]
                    RegisterOperation.SHIFT_RIGHT_UNSIGNED -> stack[a] = stack[b] ushr stack[c]
                    RegisterOperation.AND -> stack[a] = stack[b] and stack[c]
                    RegisterOperation.OR -> stack[a] = stack[b] or stack[c]
                    RegisterOperation.XOR -> stack[a] = stack[b] xor stack[c]

                    RegisterOperation.ADD_FLOAT -> {
                        stack[a] = (Float.fromBits(stack[b]) + Float.fromBits(stack[c])).toBits()
                    }

                    RegisterOperation.SUBTRACT_FLOAT -> {
                        stack[a] = (Float.fromBits(stack[b]) - Float.fromBits(stack[c])).toBits()
                    }

                    RegisterOperation.MULTIPLY_FLOAT -> {
                        stack[a] = (Float.fromBits(stack[b]) * Float.fromBits(stack[c])).toBits()
                    }

                    RegisterOperation.DIVIDE_FLOAT -> {
                        stack[a] = (Float.fromBits(stack[b]) / Float.fromBits(stack[c])).toBits()
                    }

                    RegisterOperation.ADD_CONSTANT -> stack[a] = stack[b] + (word shr SHIFT_C)
                    RegisterOperation.MULTIPLY_CONSTANT -> stack[a] = stack[b] * (word shr SHIFT_C)
                    RegisterOperation.DIVIDE_CONSTANT -> stack[a] = stack[b] / (word shr SHIFT_C)
                    RegisterOperation.REMAINDER_CONSTANT -> stack[a] = stack[b] % (word shr SHIFT_C)
                    RegisterOperation.SHIFT_LEFT_CONSTANT -> stack[a] = stack[b] shl (word shr SHIFT_C)
                    RegisterOperation.SHIFT_RIGHT_CONSTANT -> stack[a] = stack[b] shr (word shr SHIFT_C)
                    RegisterOperation.SHIFT_RIGHT_UNSIGNED_CONSTANT -> stack[a] = stack[b] ushr (word shr SHIFT_C)
                    RegisterOperation.AND_CONSTANT -> stack[a] = stack[b] and (word shr SHIFT_C)
                    RegisterOperation.INCREMENT -> stack[a] += word shr HALF_BITS
                    RegisterOperation.NEGATE -> stack[a] = -stack[b]
                    RegisterOperation.NEGATE_FLOAT -> stack[a] = (-Float.fromBits(stack[b])).toBits()
                    RegisterOperation.TO_BYTE -> stack[a] = stack[b].toByte().toInt()

                    RegisterOperation.TO_CHARACTER -> {
                        val value = stack[b]
                        if (value and SIXTEENTH_BIT != 0) break@blocks
                        stack[a] = value and LOW_HALF
                    }

                    RegisterOperation.TO_SHORT -> stack[a] = stack[b].toShort().toInt()
                    RegisterOperation.INT_TO_FLOAT -> stack[a] = stack[b].toFloat().toBits()
                    RegisterOperation.FLOAT_TO_INT -> stack[a] = Float.fromBits(stack[b]).toInt()

                    RegisterOperation.COMPARE_FLOAT -> {
                        val first = Float.fromBits(stack[b])
                        val second = Float.fromBits(stack[c])
                        stack[a] = when {
                            first < second -> -1
                            first > second -> 1
                            first == second -> 0
                            else -> break@blocks
                        }
                    }

                    RegisterOperation.FIELD -> {
                        val reference = stack[b]
                        if (reference == 0) break@blocks
                        stack[a] = words[reference + Heap.HEADER_WORDS + (word ushr SHIFT_C)]
                    }

                    RegisterOperation.SET_FIELD -> {
                        val reference = stack[a]
                        if (reference == 0) break@blocks
                        words[reference + Heap.HEADER_WORDS + (word ushr SHIFT_B and BYTE)] = stack[c]
                    }

                    RegisterOperation.STATIC -> stack[a] = statics[word ushr SHIFT_B and BYTE]
                    RegisterOperation.SET_STATIC -> statics[word ushr SHIFT_A and BYTE] = stack[b]

                    RegisterOperation.ELEMENT -> {
                        val array = stack[b]
                        val index = stack[c]
                        if (array == 0 || index < 0 || index >= words[array + 1]) break@blocks
                        stack[a] = words[array + Heap.HEADER_WORDS + index]
                    }

                    RegisterOperation.SET_ELEMENT -> {
                        val array = stack[a]
                        val index = stack[b]
                        if (array == 0 || index < 0 || index >= words[array + 1]) break@blocks
                        words[array + Heap.HEADER_WORDS + index] = stack[c]
                    }

                    RegisterOperation.SET_BYTE -> {
                        val array = stack[a]
                        val index = stack[b]
                        if (array == 0 || index < 0 || index >= words[array + 1]) break@blocks
                        words[array + Heap.HEADER_WORDS + index] = stack[c].toByte().toInt()
                    }

                    RegisterOperation.SET_CHARACTER -> {
                        val array = stack[a]
                        val index = stack[b]
                        if (array == 0 || index < 0 || index >= words[array + 1]) break@blocks
                        val value = stack[c]
                        if (value and SIXTEENTH_BIT != 0) break@blocks
                        words[array + Heap.HEADER_WORDS + index] = value and LOW_HALF
                    }

                    RegisterOperation.SET_SHORT -> {
                        val array = stack[a]
                        val index = stack[b]
                        if (array == 0 || index < 0 || index >= words[array + 1]) break@blocks
                        words[array + Heap.HEADER_WORDS + index] = stack[c].toShort().toInt()
                    }

                    RegisterOperation.LENGTH -> {
                        val array = stack[b]
                        if (array == 0) break@blocks
                        stack[a] = words[array + 1]
                    }

                    RegisterOperation.FIELD_ELEMENT -> {
                        val reference = stack[b]
                        if (reference == 0) break@blocks
                        val array = words[reference + Heap.HEADER_WORDS + code[at + 1]]
                        val index = stack[c]
                        if (array == 0 || index < 0 || index >= words[array + 1]) break@blocks
                        stack[a] = words[array + Heap.HEADER_WORDS + index]
                        at++
                    }

                    RegisterOperation.MULTIPLY_CONSTANT_ADD -> {
                        stack[a] = stack[b] * (word shr SHIFT_C) + stack[base + code[++at]]
                    }

                    RegisterOperation.SET_FIELD_SUM -> {
                        val reference = stack[a]
                        if (reference == 0) break@blocks
                        words[reference + Heap.HEADER_WORDS + code[++at]] = stack[b] + stack[c]
                    }

                    RegisterOperation.INCREMENT_FIELD -> {
                        val reference = stack[a]
                        if (reference == 0) break@blocks
                        words[reference + Heap.HEADER_WORDS + (word ushr SHIFT_B and BYTE)] += word shr SHIFT_C
                    }

                    RegisterOperation.INCREMENT_STATIC -> statics[word ushr SHIFT_A and BYTE] += word shr SHIFT_C

                    RegisterOperation.INCREMENT_IF_LESS_CONSTANT -> {
                        val value = stack[a] + (word shr SHIFT_C)
                        stack[a] = value
                        at = if (value < code[at + 1]) code[at + 2] else code[at + 3]
                        continue@blocks
                    }

                    RegisterOperation.INCREMENT_IF_LESS -> {
                        val value = stack[a] + (word shr SHIFT_C)
                        stack[a] = value
                        at = if (value < stack[b]) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_NO_BIT -> {
                        at = if (stack[a] and (word shr SHIFT_C) == 0) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_FIELD_EQUAL_CONSTANT -> {
                        val reference = stack[a]
                        if (reference == 0) break@blocks
                        val value = words[reference + Heap.HEADER_WORDS + (word ushr SHIFT_B and BYTE)]
                        at = if (value == word shr SHIFT_C) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_FIELD_LESS_CONSTANT -> {
                        val reference = stack[a]
                        if (reference == 0) break@blocks
                        val value = words[reference + Heap.HEADER_WORDS + (word ushr SHIFT_B and BYTE)]
                        at = if (value < word shr SHIFT_C) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_EQUAL -> {
                        at = if (stack[a] == stack[b]) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_NOT_EQUAL -> {
                        at = if (stack[a] != stack[b]) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_LESS -> {
                        at = if (stack[a] < stack[b]) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_NOT_LESS -> {
                        at = if (stack[a] >= stack[b]) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_EQUAL_CONSTANT -> {
                        at = if (stack[a] == word shr HALF_BITS) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_NOT_EQUAL_CONSTANT -> {
                        at = if (stack[a] != word shr HALF_BITS) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_LESS_CONSTANT -> {
                        at = if (stack[a] < word shr HALF_BITS) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.IF_NOT_LESS_CONSTANT -> {
                        at = if (stack[a] >= word shr HALF_BITS) code[at + 1] else code[at + 2]
                        continue@blocks
                    }

                    RegisterOperation.INITIALIZE -> if (!isInitialized[word ushr SHIFT_A and BYTE]) break@blocks

                    RegisterOperation.CALL_STATIC -> {
                        number = word ushr SHIFT_B and BYTE
                        break
                    }

                    RegisterOperation.CALL_EXACTLY -> {
                        val receiver = stack[c]
                        if (receiver == 0) break@blocks
                        stack[a] = receiver
                        number = word ushr SHIFT_B and BYTE
                        break
                    }

                    RegisterOperation.CALL_VIRTUAL -> {
                        val receiver = stack[c]
                        if (receiver == 0) break@blocks
                        stack[a] = receiver
                        number = virtualMethods[words[receiver]][word ushr SHIFT_B and BYTE]
                        break
                    }

                    RegisterOperation.RETURN -> {
                        if (frame.lock != 0 || thread.depth == 1) break@blocks
                        thread.pop()
                        frame = thread.frame
                        base = frame.base
                        val caller = frame.body.registerCode
                        // A static initializer returns to the operation that needed it, inside a block.
                        val entry = if (caller == null) -1 else caller.entries[frame.next]
                        if (caller == null || entry < 0) {
                            save(left, begun)
                            return Result.CONTINUE
                        }
                        registers = caller
                        code = caller.code
                        at = entry
                        continue@blocks
                    }

                    RegisterOperation.RETURN_VALUE -> {
                        if (frame.lock != 0 || thread.depth == 1) break@blocks
                        stack[base] = stack[a]
                        thread.pop()
                        frame = thread.frame
                        base = frame.base
                        val caller = frame.body.registerCode
                        if (caller == null) {
                            frame.top++
                            save(left, begun)
                            return Result.CONTINUE
                        }
                        registers = caller
                        code = caller.code
                        at = caller.entries[frame.next]
                        continue@blocks
                    }

                    RegisterOperation.PLAIN -> {
                        val position = code[at + 1]
                        frame.next = position + 1
                        frame.top = a
                        save(left, begun)
                        begun = 0
                        rare.execute(thread, frame, frame.body.code[position])
                        if (thread.pending != 0 || thread.state != ThreadState.READY || thread.frame !== frame) {
                            return Result.CONTINUE
                        }
                        left = machine.budget
                        at = registers.entries[frame.next]
                        if (at < 0) return Result.CONTINUE
                        continue@blocks
                    }

                    RegisterOperation.RETURN_WIDE -> break@blocks

                    else -> {
                        if (word and BYTE < RegisterOperation.FIRST_WIDE) {
                            number = far.method(code, at, stack, base)
                            if (number < 0) break@blocks
                            break
                        }
                        val last = wide.execute(frame, code, at, stack)
                        if (last < 0) break@blocks
                        at = last
                    }
                }
                at++
            }
            // A call. It is not in its branch because the compiler for wasm makes a table of the branches only if each has
            // one constant.
            val first = base + (code[at] ushr SHIFT_A and BYTE)
            frame.next = code[at + 1]
            val method = methods[number]
            val callee = callable[number]
            val called = if (callee == null) null else thread.push(first, method.frameWords)
            if (callee == null || called == null) {
                frame.top = first + method.argumentWords
                save(left, begun)
                call(thread, frame, method, code[at] and BYTE)
                return Result.CONTINUE
            }
            frame.top = first
            stack = thread.stack
            called.begin(method, first, stack)
            frame = called
            base = first
            registers = callee
            code = callee.code
            at = 0
        }
        exit(frame, registers, at, stack, left, begun)
        return Result.NEEDS_STACK_CODE
    }

    /** Prepares [frame] to continue with the stack code of the instruction at [at]. */
    private fun exit(frame: Frame, registers: RegisterCode, at: Int, stack: IntArray, left: Int, begun: Int) {
        frame.next = registers.exitPosition(at)
        frame.top = registers.completeStack(at, stack, frame.base)
        save(left + registers.bytecodesAfter(at), begun - registers.statementsAfter(at))
    }

    /** Calls [method], whose call [operation] is not as simple as others. */
    private fun call(thread: VmThread, frame: Frame, method: LinkedMethod, operation: Int) {
        val isVirtual =
            operation == RegisterOperation.CALL_VIRTUAL || operation == RegisterOperation.CALL_INTERFACE
        calls.call(thread, frame, method, if (isVirtual) VIRTUAL_CALL_WORDS else CALL_WORDS, isVirtual)
    }

    private fun save(left: Int, begun: Int) {
        machine.budget = left
        gate.begin(begun)
    }

    private companion object {
        const val BYTE = 0xFF
        const val SHIFT_A = 8
        const val SHIFT_B = 16
        const val SHIFT_C = 24
        const val HALF_BITS = 16
        const val LOW_HALF = 0xFFFF
        const val SIXTEENTH_BIT = 0x8000
        const val MAX_SHORT = 32_767

        /** Words of a call in the stack code. */
        const val CALL_WORDS = 2
        const val VIRTUAL_CALL_WORDS = 3
    }
}
