package robotran.tinyvm.link

/**
 * Compiles the operations of stack code on array elements and fields to instructions of [RegisterCode].
 *
 * @param instructions receives the instructions.
 * @param exit the exit to the operation being compiled.
 */
internal class MemberCompiler(
    private val operands: OperandStack,
    private val instructions: MutableList<RegisterInstruction>,
    private val exit: () -> BlockExit,
) {
    /** Compiles [operation] on an array element; returns false if it has no instruction. */
    fun element(operation: Int): Boolean {
        when (operation) {
            Operation.ELEMENT, Operation.ELEMENT_WIDE -> {
                val exit = exit()
                val index = operands.popRegister()
                val array = operands.popRegister()
                emit(RegisterOperation.ELEMENT, operands.pushResult(), array, index, exit)
                if (operation == Operation.ELEMENT_WIDE) operands.pushConstant(0)
            }

            Operation.SET_ELEMENT -> setElement(RegisterOperation.SET_ELEMENT)
            Operation.SET_BYTE -> setElement(RegisterOperation.SET_BYTE)
            Operation.SET_CHARACTER -> setElement(RegisterOperation.SET_CHARACTER)
            Operation.SET_SHORT -> setElement(RegisterOperation.SET_SHORT)
            Operation.SET_WIDE -> setElement(RegisterOperation.SET_ELEMENT, isWide = true)
            else -> return false
        }
        return true
    }

    /** Compiles [operation] on a field or the length of an array; returns false if it has no instruction. */
    fun compile(operation: Int, operand: Int): Boolean {
        when (operation) {
            Operation.STATIC, Operation.STATIC_WIDE -> {
                if (operand in RegisterInstruction.REGISTERS) {
                    emit(RegisterOperation.STATIC, operands.pushResult(), operand)
                } else {
                    far(RegisterOperation.STATIC_FAR, operands.pushResult(), operand)
                }
                if (operation == Operation.STATIC_WIDE) operands.pushConstant(0)
            }

            Operation.SET_STATIC, Operation.SET_STATIC_WIDE -> {
                if (operation == Operation.SET_STATIC_WIDE) operands.pop()
                if (operand in RegisterInstruction.REGISTERS) {
                    emit(RegisterOperation.SET_STATIC, operand, operands.popRegister())
                } else {
                    far(RegisterOperation.SET_STATIC_FAR, operands.popRegister(), operand)
                }
            }

            Operation.FIELD, Operation.FIELD_WIDE -> {
                val exit = exit()
                val reference = operands.popRegister()
                emit(RegisterOperation.FIELD, operands.pushResult(), reference, operand, exit)
                if (operation == Operation.FIELD_WIDE) operands.pushConstant(0)
            }

            Operation.SET_FIELD, Operation.SET_FIELD_WIDE -> {
                val exit = exit()
                if (operation == Operation.SET_FIELD_WIDE) operands.pop()
                val value = operands.popRegister()
                emit(RegisterOperation.SET_FIELD, operands.popRegister(), operand, value, exit)
            }

            Operation.LENGTH -> {
                val exit = exit()
                val array = operands.popRegister()
                emit(RegisterOperation.LENGTH, operands.pushResult(), array, exit = exit)
            }

            else -> return false
        }
        return true
    }

    private fun setElement(operation: Int, isWide: Boolean = false) {
        val exit = exit()
        if (isWide) operands.pop()
        val value = operands.popRegister()
        val index = operands.popRegister()
        emit(operation, operands.popRegister(), index, value, exit)
    }

    private fun far(operation: Int, register: Int, slot: Int) {
        instructions += RegisterInstruction(operation, register, words = intArrayOf(slot))
    }

    private fun emit(operation: Int, a: Int, b: Int, c: Int = 0, exit: BlockExit? = null) {
        instructions += RegisterInstruction(operation, a, b, c, exit)
    }
}
