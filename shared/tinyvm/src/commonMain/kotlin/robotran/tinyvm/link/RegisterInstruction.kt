package robotran.tinyvm.link

/**
 * An instruction of a block that is being compiled; see [RegisterOperation].
 *
 * @property exit where the stack code continues if the instruction cannot do its work; null if it always can.
 * @property words the words after the first, without the blocks to continue with.
 * @property successors the positions in the stack code of the blocks to continue with.
 */
internal class RegisterInstruction(
    val operation: Int,
    val a: Int = 0,
    val b: Int = 0,
    val c: Int = 0,
    val exit: BlockExit? = null,
    val words: IntArray = NO_WORDS,
    val successors: IntArray = NO_WORDS,
) {
    /** Operands B and C as one signed number. */
    val d: Int get() = (b or (c shl OPERAND_BITS)).toShort().toInt()

    val size: Int get() = 1 + words.size + successors.size

    /** The first word. */
    val word: Int get() = operation or (a shl OPERAND_BITS) or (b shl 2 * OPERAND_BITS) or (c shl 3 * OPERAND_BITS)

    /** Whether all operands fit. */
    val isEncodable: Boolean get() = a in REGISTERS && b in REGISTERS && c in REGISTERS

    /** The same instruction with its result in [register]. */
    fun withResultIn(register: Int) = RegisterInstruction(operation, register, b, c, exit, words, successors)

    companion object {
        private val NO_WORDS = IntArray(0)
        private const val OPERAND_BITS = 8
        private const val OPERAND_MASK = 0xFF

        /** The numbers that fit one operand if it is unsigned. */
        val REGISTERS = 0..OPERAND_MASK

        /** The constants that fit operand C, and those that fit operand D. */
        val SHORT_CONSTANTS = -128..127
        val LONG_CONSTANTS = -32_768..32_767

        /** An instruction whose operand D is [constant]. */
        fun withConstant(operation: Int, a: Int, constant: Int, successors: IntArray = NO_WORDS) = RegisterInstruction(
            operation,
            a,
            constant and OPERAND_MASK,
            constant shr OPERAND_BITS and OPERAND_MASK,
            successors = successors,
        )

        /** An instruction that puts the constant [value] in [register]. */
        fun constant(register: Int, value: Int) = if (value in LONG_CONSTANTS) {
            withConstant(RegisterOperation.CONSTANT, register, value)
        } else {
            RegisterInstruction(RegisterOperation.WIDE_CONSTANT, register, words = intArrayOf(value))
        }

        /** An instruction whose operand C is [constant]. */
        fun withShortConstant(operation: Int, a: Int, b: Int, constant: Int) =
            RegisterInstruction(operation, a, b, constant and OPERAND_MASK)
    }
}

/**
 * A place where a block can exit to the stack code.
 *
 * @property position in the stack code.
 * @property bytecodes of the block before it.
 * @property statements likewise.
 * @property end the register after the topmost operand.
 * @property delayed the operands that are not on the stack; see [OperandStack.delayed].
 */
internal class BlockExit(
    val position: Int,
    val bytecodes: Int,
    val statements: Int,
    val end: Int,
    val delayed: IntArray,
)

/**
 * A compiled block.
 *
 * @property start the exit before its first instruction.
 * @property bytecodes their number in the block.
 * @property statements likewise.
 * @property next where the method may continue after a call or another operation that ends the block without a successor.
 */
internal class RegisterBlock(
    val instructions: List<RegisterInstruction>,
    val start: BlockExit,
    val bytecodes: Int,
    val statements: Int,
    val next: List<Int>,
)
