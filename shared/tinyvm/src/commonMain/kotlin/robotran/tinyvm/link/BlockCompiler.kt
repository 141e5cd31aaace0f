package robotran.tinyvm.link

/**
 * Compiles blocks of a method's stack code to instructions of [RegisterCode].
 *
 * @param code the stack code.
 * @param depths the operand words before each position.
 * @param isJoin whether a jump or branch goes to a position.
 * @param locals the number of locals, which is the register of the lowest operand.
 * @param switches the tables of its `switch` statements.
 * @param isExact whether it is for an exact machine.
 * @param argumentWords the argument words of a method, by its number.
 */
internal class BlockCompiler(
    private val code: IntArray,
    private val depths: IntArray,
    private val isJoin: BooleanArray,
    private val locals: Int,
    private val switches: List<SwitchTable>,
    private val isExact: Boolean,
    private val argumentWords: (Int) -> Int,
) {
    private val instructions = ArrayList<RegisterInstruction>()
    private val operands = OperandStack(locals, instructions)
    private val calculations = CalculationCompiler(operands, instructions, ::exit)
    private val wide = WideCompiler(operands, instructions, ::exit)
    private val joined = HashSet<Int>()
    private var position = 0
    private var bytecodes = 0
    private var statements = 0
    private var continuations: List<Int> = emptyList()

    /**
     * Compiles the block at [start]. It contains also what follows it without a condition, up to a limit, so code after
     * a join is compiled several times.
     */
    fun compile(start: Int): RegisterBlock {
        instructions.clear()
        joined.clear()
        continuations = emptyList()
        position = start
        bytecodes = 0
        statements = 0
        operands.reset(depths[start])
        val startExit = exit()
        while (continuesBlock()) compileOperation()
        val fused = InstructionFusion.fuse(instructions, locals)
        return RegisterBlock(fused, startExit, bytecodes, statements, continuations)
    }

    /** Whether the block contains the operation at [position], unless its end was reached. If not, jumps there. */
    private fun continuesBlock(): Boolean {
        if (position < 0) return false
        if (!isJoin[position] || (bytecodes < MAX_JOINED_BYTECODES && joined.add(position))) return true
        operands.complete()
        instructions += RegisterInstruction(RegisterOperation.JUMP, successors = intArrayOf(position))
        return false
    }

    private fun exit() = BlockExit(position, bytecodes, statements, operands.end, operands.delayed())

    private fun compileOperation() {
        val operation = code[position]
        val next = position + lengthOf(operation)
        when (operation) {
            Operation.STATEMENT -> {
                statements++
                position = next
                return
            }

            Operation.INITIALIZE -> {
                val type = code[position + 1]
                instructions += RegisterInstruction(RegisterOperation.INITIALIZE, type, exit = exit())
                position = next
                return
            }
        }
        when (operation) {
            Operation.JUMP -> position = code[position + 1]

            in Operation.IF_ZERO..Operation.IF_NOT_GREATER -> {
                branch(operation, intArrayOf(code[position + 1], next))
                position = END
            }

            Operation.CALL_STATIC, Operation.CALL_EXACTLY -> call(operation, argumentWords(code[position + 1]), next)
            Operation.CALL_VIRTUAL -> call(operation, code[position + 2], next)

            Operation.RETURN, Operation.RETURN_VALUE, Operation.RETURN_WIDE -> {
                if (isExact && operation == Operation.RETURN_WIDE) plain() else leave(operation)
            }

            Operation.SWITCH -> switch()
            else -> other(operation, next)
        }
        bytecodes++
    }

    private fun other(operation: Int, next: Int) {
        val first = code.getOrElse(position + 1) { 0 }
        val second = code.getOrElse(position + 2) { 0 }
        when {
            isExact && operation == Operation.CALL_INTERFACE && first in RegisterInstruction.REGISTERS -> {
                callInterface(first, second, next)
            }

            isExact && wide.compile(operation, first, second) -> {
                bytecodes += ExactCosts.of(operation)
                position = next
            }

            calculations.compile(operation, code, position) -> position = next
            else -> plain()
        }
    }

    private fun switch() {
        val index = code[position + 1]
        val register = operands.popRegister()
        operands.complete()
        instructions += RegisterInstruction(RegisterOperation.SWITCH, register, words = intArrayOf(index))
        for (target in switches[index].targets) {
            instructions += RegisterInstruction(RegisterOperation.JUMP, successors = intArrayOf(target))
        }
        position = END
    }

    private fun callInterface(method: Int, argumentWords: Int, next: Int) {
        val exit = exit()
        val first = operands.end - argumentWords
        val receiver = operands.leaveReceiver(argumentWords)
        operands.complete()
        val words = intArrayOf(next)
        instructions += RegisterInstruction(RegisterOperation.CALL_INTERFACE, first, method, receiver, exit, words)
        continuations = listOf(next)
        position = END
    }

    private fun branch(operation: Int, successors: IntArray) {
        val isAgainstZero = operation <= Operation.IF_NOT_POSITIVE
        if (isAgainstZero) operands.pushConstant(0)
        val condition = operation - if (isAgainstZero) Operation.IF_ZERO else Operation.IF_EQUAL
        val right = operands.pop()
        val left = operands.pop()
        instructions += if (left.isConstant && !right.isConstant) {
            comparison(MIRRORED[condition], right, left, successors)
        } else {
            comparison(condition, left, right, successors)
        }
    }

    private fun comparison(condition: Int, left: Operand, right: Operand, successors: IntArray): RegisterInstruction {
        val a = operands.registerOf(left)
        // There are four conditions for registers: the others are these with the operands exchanged. With a constant,
        // they are these with the next constant.
        val isOther = condition >= CONDITIONS
        if (right.isConstantIn(if (isOther) SMALLER_CONSTANTS else RegisterInstruction.LONG_CONSTANTS)) {
            operands.complete()
            val first = RegisterOperation.IF_EQUAL_CONSTANT
            return if (isOther) {
                val operation = first + NEXT_CONDITIONS - condition
                RegisterInstruction.withConstant(operation, a, right.value + 1, successors)
            } else {
                RegisterInstruction.withConstant(first + condition, a, right.value, successors)
            }
        }
        val b = operands.registerOf(right)
        operands.complete()
        val first = RegisterOperation.IF_EQUAL
        return if (isOther) {
            RegisterInstruction(first + MIRRORED[condition], b, a, successors = successors)
        } else {
            RegisterInstruction(first + condition, a, b, successors = successors)
        }
    }

    private fun call(operation: Int, argumentWords: Int, next: Int) {
        val exit = if (operation == Operation.CALL_STATIC) null else exit()
        val first = operands.end - argumentWords
        val receiver = if (operation == Operation.CALL_STATIC) 0 else operands.leaveReceiver(argumentWords)
        operands.complete()
        val method = code[position + 1]
        instructions += if (operation != Operation.CALL_VIRTUAL && method !in RegisterInstruction.REGISTERS) {
            val far = RegisterOperation.CALL_STATIC_FAR + operation - Operation.CALL_STATIC
            RegisterInstruction(far, first, 0, receiver, exit, intArrayOf(next, method))
        } else {
            val near = RegisterOperation.CALL_STATIC + operation - Operation.CALL_STATIC
            RegisterInstruction(near, first, method, receiver, exit, intArrayOf(next))
        }
        continuations = listOf(next)
        position = END
    }

    private fun leave(operation: Int) {
        val exit = exit()
        if (operation == Operation.RETURN_WIDE) operands.pop()
        val register = if (operation == Operation.RETURN) 0 else operands.popRegister()
        val first = RegisterOperation.RETURN - Operation.RETURN
        instructions += RegisterInstruction(first + operation, register, exit = exit)
        position = END
    }

    /** Ends the block with the operation at [position], which has no instruction of its own. */
    private fun plain() {
        operands.complete()
        instructions += RegisterInstruction(RegisterOperation.PLAIN, operands.end, words = intArrayOf(position))
        continuations = when (code[position]) {
            Operation.THROW, Operation.RETURN_WIDE -> emptyList()
            else -> listOf(position + lengthOf(code[position]))
        }
        position = END
    }

    private companion object {
        const val END = -1

        /** The conditions of [RegisterOperation] are the first ones of [Operation]. */
        const val CONDITIONS = 4

        /** Greater (4) than a constant is not less (3) than the next one; not greater (5) is less (2). */
        const val NEXT_CONDITIONS = 7

        /** The condition for exchanged operands. */
        val MIRRORED = intArrayOf(0, 1, 4, 5, 2, 3)

        /** The constants whose next one fits an instruction. */
        val SMALLER_CONSTANTS = RegisterInstruction.LONG_CONSTANTS.first until RegisterInstruction.LONG_CONSTANTS.last

        /** A block with at least this many bytecodes does not continue in another. */
        const val MAX_JOINED_BYTECODES = 32
    }
}
