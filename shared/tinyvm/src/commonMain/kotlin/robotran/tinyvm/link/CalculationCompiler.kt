package robotran.tinyvm.link

/**
 * Compiles the operations of stack code that do not end a block to instructions of [RegisterCode].
 *
 * @param instructions receives the instructions.
 * @param exit the exit to the operation being compiled.
 */
internal class CalculationCompiler(
    private val operands: OperandStack,
    private val instructions: MutableList<RegisterInstruction>,
    private val exit: () -> BlockExit,
) {
    private val members = MemberCompiler(operands, instructions, exit)

    /** Compiles [operation], which is at [position] of [code]; returns false if it is not one of these. */
    fun compile(operation: Int, code: IntArray, position: Int): Boolean {
        val operand = code.getOrElse(position + 1) { 0 }
        return when (operation) {
            in Operation.PUSH..Operation.INCREMENT -> local(operation, operand, code.getOrElse(position + 2) { 0 })
            in Operation.ELEMENT..Operation.SET_WIDE -> members.element(operation)
            in Operation.POP..Operation.SWAP -> rearrange(operation)
            in Operation.STATIC..Operation.LENGTH -> members.compile(operation, operand)
            Operation.NOTHING -> true
            else -> calculate(operation)
        }
    }

    private fun local(operation: Int, operand: Int, increment: Int): Boolean {
        when (operation) {
            Operation.PUSH -> operands.pushConstant(operand)

            Operation.PUSH_WIDE -> {
                operands.pushConstant(operand)
                operands.pushConstant(0)
            }

            Operation.LOAD -> operands.pushLocal(operand)

            Operation.LOAD_WIDE -> {
                operands.pushLocal(operand)
                operands.pushConstant(0)
            }

            Operation.STORE -> store(operand)

            Operation.STORE_WIDE -> {
                operands.pop()
                store(operand)
            }

            Operation.INCREMENT -> {
                operands.rescue(operand)
                instructions += RegisterInstruction.withConstant(RegisterOperation.INCREMENT, operand, increment)
            }

            else -> return false
        }
        return true
    }

    /** Stores the topmost operand; if the last instruction computed it, that puts its result in the local at once. */
    private fun store(local: Int) {
        val value = operands.pop()
        val last = instructions.lastOrNull()
        if (value.kind == Operand.ON_STACK && last != null && last.operation in RegisterOperation.WITH_RESULT &&
            last.a == value.register && !operands.uses(local)
        ) {
            instructions[instructions.lastIndex] = last.withResultIn(local)
            return
        }
        operands.rescue(local)
        instructions += when (value.kind) {
            Operand.CONSTANT -> RegisterInstruction.constant(local, value.value)
            Operand.LOCAL -> RegisterInstruction(RegisterOperation.MOVE, local, value.value)
            else -> RegisterInstruction(RegisterOperation.MOVE, local, value.register)
        }
    }

    private fun rearrange(operation: Int): Boolean {
        when (operation) {
            Operation.POP -> operands.pop()

            Operation.POP_2 -> {
                operands.pop()
                operands.pop()
            }

            Operation.DUPLICATE -> operands.pushCopy(0)

            Operation.DUPLICATE_2 -> {
                operands.pushCopy(1)
                operands.pushCopy(1)
            }

            else -> return false
        }
        return true
    }

    private fun calculate(operation: Int): Boolean {
        when (operation) {
            in Operation.ADD..Operation.REMAINDER, in Operation.SHIFT_LEFT..Operation.XOR -> {
                wholeBinary(BINARY.getValue(operation))
            }

            in Operation.ADD_FLOAT..Operation.DIVIDE_FLOAT -> {
                binary(RegisterOperation.ADD_FLOAT + operation - Operation.ADD_FLOAT)
            }

            // A brick's doubles have 32 bits, with an unused word above.
            in Operation.ADD_DOUBLE..Operation.DIVIDE_DOUBLE -> {
                operands.pop()
                val right = operands.pop()
                operands.pop()
                val left = operands.pop()
                emit(RegisterOperation.ADD_FLOAT + operation - Operation.ADD_DOUBLE, left, right)
                operands.pushConstant(0)
            }

            Operation.COMPARE_FLOAT_LOW, Operation.COMPARE_FLOAT_HIGH -> binary(RegisterOperation.COMPARE_FLOAT, exit())

            Operation.COMPARE_DOUBLE_LOW, Operation.COMPARE_DOUBLE_HIGH -> {
                val exit = exit()
                operands.pop()
                val right = operands.pop()
                operands.pop()
                emit(RegisterOperation.COMPARE_FLOAT, operands.pop(), right, exit)
            }

            else -> return convert(operation)
        }
        return true
    }

    private fun convert(operation: Int): Boolean {
        val (takesWide, calculation, givesWide) = UNARY[operation] ?: return false
        val exit = if (calculation == RegisterOperation.TO_CHARACTER) exit() else null
        if (takesWide) operands.pop()
        if (calculation != RegisterOperation.MOVE) {
            val value = operands.popRegister()
            instructions += RegisterInstruction(calculation, operands.pushResult(), value, exit = exit)
        }
        if (givesWide) operands.pushConstant(0)
        return true
    }

    /** An operation on whole numbers, which may have a form with a constant. */
    private fun wholeBinary(operation: Int) {
        // A sum needs an exit if it becomes part of an instruction that needs one.
        val exit = if (operation in DIVISIONS || operation == RegisterOperation.ADD) exit() else null
        var right = operands.pop()
        var left = operands.pop()
        if (left.isConstant && operation in COMMUTATIVE) left = right.also { right = left }
        val isSubtraction = operation == RegisterOperation.SUBTRACT
        val constantOperation = WITH_CONSTANT[operation]
        val constants = if (operation in DIVISIONS) POSITIVE_CONSTANTS else RegisterInstruction.SHORT_CONSTANTS
        val constant = if (isSubtraction) -right.value else right.value
        if (constantOperation == null || !right.isConstant || constant !in constants) {
            emit(operation, left, right, exit)
            return
        }
        val b = operands.registerOf(left)
        instructions +=
            RegisterInstruction.withShortConstant(constantOperation, operands.pushResult(), b, constant)
    }

    private fun binary(operation: Int, exit: BlockExit? = null) {
        val right = operands.pop()
        emit(operation, operands.pop(), right, exit)
    }

    private fun emit(operation: Int, left: Operand, right: Operand, exit: BlockExit? = null) {
        val b = operands.registerOf(left)
        val c = operands.registerOf(right)
        instructions += RegisterInstruction(operation, operands.pushResult(), b, c, exit)
    }

    private companion object {
        val BINARY = mapOf(
            Operation.ADD to RegisterOperation.ADD,
            Operation.SUBTRACT to RegisterOperation.SUBTRACT,
            Operation.MULTIPLY to RegisterOperation.MULTIPLY,
            Operation.DIVIDE to RegisterOperation.DIVIDE,
            Operation.REMAINDER to RegisterOperation.REMAINDER,
            Operation.SHIFT_LEFT to RegisterOperation.SHIFT_LEFT,
            Operation.SHIFT_RIGHT to RegisterOperation.SHIFT_RIGHT,
            Operation.SHIFT_RIGHT_UNSIGNED to RegisterOperation.SHIFT_RIGHT_UNSIGNED,
            Operation.AND to RegisterOperation.AND,
            Operation.OR to RegisterOperation.OR,
            Operation.XOR to RegisterOperation.XOR,
        )

        val DIVISIONS = setOf(RegisterOperation.DIVIDE, RegisterOperation.REMAINDER)

        val COMMUTATIVE = setOf(RegisterOperation.ADD, RegisterOperation.MULTIPLY, RegisterOperation.AND)

        /** A subtraction adds the negative constant. */
        val WITH_CONSTANT = mapOf(
            RegisterOperation.ADD to RegisterOperation.ADD_CONSTANT,
            RegisterOperation.SUBTRACT to RegisterOperation.ADD_CONSTANT,
            RegisterOperation.MULTIPLY to RegisterOperation.MULTIPLY_CONSTANT,
            RegisterOperation.DIVIDE to RegisterOperation.DIVIDE_CONSTANT,
            RegisterOperation.REMAINDER to RegisterOperation.REMAINDER_CONSTANT,
            RegisterOperation.SHIFT_LEFT to RegisterOperation.SHIFT_LEFT_CONSTANT,
            RegisterOperation.SHIFT_RIGHT to RegisterOperation.SHIFT_RIGHT_CONSTANT,
            RegisterOperation.SHIFT_RIGHT_UNSIGNED to RegisterOperation.SHIFT_RIGHT_UNSIGNED_CONSTANT,
            RegisterOperation.AND to RegisterOperation.AND_CONSTANT,
        )

        val POSITIVE_CONSTANTS = 1..RegisterInstruction.SHORT_CONSTANTS.last

        /**
         * The operations with one operand: whether it is wide, the instruction ([RegisterOperation.MOVE] if the value
         * stays the same), and whether the result is wide.
         */
        val UNARY = mapOf(
            Operation.NEGATE to Triple(false, RegisterOperation.NEGATE, false),
            Operation.NEGATE_FLOAT to Triple(false, RegisterOperation.NEGATE_FLOAT, false),
            Operation.NEGATE_DOUBLE to Triple(true, RegisterOperation.NEGATE_FLOAT, true),
            Operation.WIDEN to Triple(false, RegisterOperation.MOVE, true),
            Operation.NARROW to Triple(true, RegisterOperation.MOVE, false),
            Operation.INT_TO_FLOAT to Triple(false, RegisterOperation.INT_TO_FLOAT, false),
            Operation.INT_TO_DOUBLE to Triple(false, RegisterOperation.INT_TO_FLOAT, true),
            Operation.FLOAT_TO_INT to Triple(false, RegisterOperation.FLOAT_TO_INT, false),
            Operation.FLOAT_TO_LONG to Triple(false, RegisterOperation.FLOAT_TO_INT, true),
            Operation.DOUBLE_TO_INT to Triple(true, RegisterOperation.FLOAT_TO_INT, false),
            Operation.DOUBLE_TO_LONG to Triple(true, RegisterOperation.FLOAT_TO_INT, true),
            Operation.TO_BYTE to Triple(false, RegisterOperation.TO_BYTE, false),
            Operation.TO_CHARACTER to Triple(false, RegisterOperation.TO_CHARACTER, false),
            Operation.TO_SHORT to Triple(false, RegisterOperation.TO_SHORT, false),
        )
    }
}
