package robotran.tinyvm.link

/**
 * A method's code for a register machine, which takes fewer and faster instructions than the stack code it is compiled
 * from. It consists of blocks. A block is entered only at its start, and has all its bytecodes charged there: its first
 * word holds their number in the lower half and the number of its statements in the upper half. At the start and the end
 * of a block, all operands are on the stack as in the stack code; in between, it may exit to the stack code, which needs
 * an entry in the exit table.
 *
 * @property code blocks of instructions of [RegisterOperation]. The method begins at index 0.
 * @property entries for each position in the stack code, the index of the block that starts there, -1 if none does.
 */
internal class RegisterCode(
    val code: IntArray,
    val entries: IntArray,
    private val exits: IntArray,
    private val exitTable: IntArray,
) {
    /** The entry in the exit table for the word at [index]. */
    private fun entry(index: Int): Int = exits[index]

    /** The position in the stack code that corresponds to the instruction at [index]. */
    fun exitPosition(index: Int): Int = exitTable[entry(index)]

    /** The charged bytecodes of its block that are not executed before the instruction at [index]. */
    fun bytecodesAfter(index: Int): Int = exitTable[entry(index) + 1]

    /** The counted statements of its block that do not begin before the instruction at [index]. */
    fun statementsAfter(index: Int): Int = exitTable[entry(index) + 2]

    /**
     * Puts the operands that are not on the stack yet there, in the frame at [base] of [stack]; returns the end of the
     * operands.
     */
    fun completeStack(index: Int, stack: IntArray, base: Int): Int {
        val entry = entry(index)
        var at = entry + EXIT_HEADER
        repeat(exitTable[entry + EXIT_HEADER - 1]) {
            val value = exitTable[at + 2]
            stack[base + exitTable[at]] = if (exitTable[at + 1] == Operand.LOCAL) stack[base + value] else value
            at += DELAYED_OPERAND_WORDS
        }
        return base + exitTable[entry + 3]
    }

    companion object {
        /**
         * Words of an entry before its delayed operands: position, bytecodes, statements, end of the operands, number of
         * delayed operands.
         */
        const val EXIT_HEADER = 5

        /** A register, the kind of [Operand] to put there, and its value. */
        const val DELAYED_OPERAND_WORDS = 3
    }
}
