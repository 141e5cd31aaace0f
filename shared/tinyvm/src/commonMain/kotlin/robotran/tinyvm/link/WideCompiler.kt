package robotran.tinyvm.link

/**
 * Compiles the operations of an exact machine that do not end a block to instructions of [RegisterCode].
 *
 * @param instructions receives the instructions.
 * @param exit the exit to the operation being compiled.
 */
internal class WideCompiler(
    private val operands: OperandStack,
    private val instructions: MutableList<RegisterInstruction>,
    private val exit: () -> BlockExit,
) {
    /** Compiles [operation], whose first operand is [operand]; returns false if it has no instruction. */
    fun compile(operation: Int, operand: Int, second: Int): Boolean {
        when (operation) {
            in Operation.PUSH_LONG..Operation.SET_STATIC_LONG -> move(operation, operand, second)
            in Operation.FIELD_LONG..Operation.SET_ELEMENT_LONG -> access(operation, operand)
            in Operation.ADD_LONG..Operation.COMPARE_DOUBLE_64_HIGH -> calculate(operation)
            Operation.CAST, Operation.IS_INSTANCE, Operation.SET_REFERENCE -> objects(operation, operand)
            else -> return false
        }
        return true
    }

    private fun move(operation: Int, operand: Int, second: Int) {
        when (operation) {
            Operation.PUSH_LONG -> {
                operands.pushConstant(operand)
                operands.pushConstant(second)
            }

            Operation.LOAD_LONG -> {
                operands.pushLocal(operand)
                operands.pushLocal(operand + 1)
            }

            Operation.STORE_LONG -> store(operand)

            Operation.STATIC_LONG -> {
                val words = intArrayOf(operand)
                instructions += RegisterInstruction(RegisterOperation.STATIC_LONG, operands.pushPair(), words = words)
            }

            else -> {
                val words = intArrayOf(operand)
                instructions +=
                    RegisterInstruction(RegisterOperation.SET_STATIC_LONG, operands.popPair(), words = words)
            }
        }
    }

    /** Stores the topmost two words; if the last instruction computed them, that puts its result there at once. */
    private fun store(local: Int) {
        val high = operands.pop()
        val low = operands.pop()
        val last = instructions.lastOrNull()
        val isUsed = operands.uses(local) || operands.uses(local + 1)
        val isLastResult = low.kind == Operand.ON_STACK && high.kind == Operand.ON_STACK && last != null &&
            last.operation in RegisterOperation.WITH_WIDE_RESULT && last.a == low.register
        if (isLastResult && !isUsed) {
            instructions[instructions.lastIndex] = last.withResultIn(local)
            return
        }
        operands.rescue(local)
        operands.rescue(local + 1)
        if (low.isConstant && high.isConstant) {
            instructions += RegisterInstruction.constant(local, low.value)
            instructions += RegisterInstruction.constant(local + 1, high.value)
            return
        }
        val from = operands.registerOf(low)
        val upper = if (high.kind == Operand.LOCAL &&
            high.value == local
        ) {
            operands.putOnStack(high)
        } else {
            operands.registerOf(high)
        }
        instructions += RegisterInstruction(RegisterOperation.MOVE_2, local, from, upper)
    }

    private fun access(operation: Int, operand: Int) {
        val exit = exit()
        when (operation) {
            Operation.FIELD_LONG -> {
                val reference = operands.popRegister()
                emit(RegisterOperation.FIELD_LONG, operands.pushPair(), reference, operand, exit)
            }

            Operation.SET_FIELD_LONG -> {
                val value = operands.popPair()
                emit(RegisterOperation.SET_FIELD_LONG, operands.popRegister(), operand, value, exit)
            }

            Operation.ELEMENT_LONG -> {
                val index = operands.popRegister()
                val array = operands.popRegister()
                emit(RegisterOperation.ELEMENT_LONG, operands.pushPair(), array, index, exit)
            }

            else -> {
                val value = operands.popPair()
                val index = operands.popRegister()
                emit(RegisterOperation.SET_ELEMENT_LONG, operands.popRegister(), index, value, exit)
            }
        }
    }

    private fun calculate(operation: Int) {
        val exit = if (operation in DIVISIONS) exit() else null
        when (operation) {
            Operation.INT_TO_LONG -> widen()
            Operation.LONG_TO_INT -> operands.pop()

            Operation.REMAINDER_FLOAT -> {
                val right = operands.popRegister()
                val left = operands.popRegister()
                emit(register(operation), operands.pushResult(), left, right)
            }

            in Operation.SHIFT_LEFT_LONG..Operation.SHIFT_RIGHT_UNSIGNED_LONG -> {
                val distance = operands.popRegister()
                val value = operands.popPair()
                emit(register(operation), operands.pushPair(), value, distance)
            }

            Operation.NEGATE_LONG, Operation.NEGATE_DOUBLE_64 -> {
                val value = operands.popPair()
                emit(register(operation), operands.pushPair(), value)
            }

            in Operation.INT_TO_DOUBLE_64..Operation.DOUBLE_64_TO_FLOAT -> {
                val value = if (operation in FROM_ONE_WORD) operands.popRegister() else operands.popPair()
                val result = if (operation in TO_ONE_WORD) operands.pushResult() else operands.pushPair()
                emit(register(operation), result, value)
            }

            else -> {
                val right = operands.popPair()
                val left = operands.popPair()
                val isComparison = operation >= Operation.COMPARE_LONG
                val result = if (isComparison) operands.pushResult() else operands.pushPair()
                emit(register(operation), result, left, right, exit)
            }
        }
    }

    /** The lower word stays where it is; the upper one has the sign. */
    private fun widen() {
        val value = operands.pop()
        if (value.isConstant) {
            operands.pushConstant(value.value)
            operands.pushConstant(value.value shr SIGN)
            return
        }
        val register = operands.registerOf(value)
        operands.push(value)
        instructions += RegisterInstruction.withShortConstant(
            RegisterOperation.SHIFT_RIGHT_CONSTANT,
            operands.pushResult(),
            register,
            SIGN,
        )
    }

    private fun objects(operation: Int, operand: Int) {
        val exit = exit()
        val words = intArrayOf(operand)
        instructions += when (operation) {
            Operation.CAST -> {
                val value = operands.pop()
                val register = operands.registerOf(value)
                operands.push(value)
                RegisterInstruction(RegisterOperation.CAST, register, exit = exit, words = words)
            }

            Operation.IS_INSTANCE -> {
                val register = operands.popRegister()
                RegisterInstruction(RegisterOperation.IS_INSTANCE, operands.pushResult(), register, words = words)
            }

            else -> {
                val value = operands.popRegister()
                val index = operands.popRegister()
                RegisterInstruction(RegisterOperation.SET_REFERENCE, operands.popRegister(), index, value, exit)
            }
        }
    }

    private fun register(operation: Int): Int = RegisterOperation.ADD_LONG + operation - Operation.ADD_LONG

    private fun emit(operation: Int, a: Int, b: Int, c: Int = 0, exit: BlockExit? = null) {
        instructions += RegisterInstruction(operation, a, b, c, exit)
    }

    private companion object {
        const val SIGN = 31
        val DIVISIONS = setOf(Operation.DIVIDE_LONG, Operation.REMAINDER_LONG)
        val FROM_ONE_WORD =
            setOf(Operation.INT_TO_DOUBLE_64, Operation.FLOAT_TO_LONG_64, Operation.FLOAT_TO_DOUBLE_64)
        val TO_ONE_WORD =
            setOf(Operation.LONG_64_TO_FLOAT, Operation.DOUBLE_64_TO_INT, Operation.DOUBLE_64_TO_FLOAT)
    }
}
