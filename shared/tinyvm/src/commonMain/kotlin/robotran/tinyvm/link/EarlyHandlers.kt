package robotran.tinyvm.link

/**
 * A brick looks for the handler of an exception with the position behind the opcode, or behind the whole instruction if it
 * is a call, and takes the first position of a handler for one of its own. So the handler also serves the instruction
 * before: one of a single byte, which throws itself, or a call, out of which the exception comes. Source: leJOS
 * `exceptions.c`, throw_exception.
 */
internal object EarlyHandlers {
    /** The length of an instruction without operands. */
    const val SINGLE_BYTE = 1

    /** The length of a call, without those of interface methods, which are two bytes longer in a class file. */
    const val CALL = 3

    /** The length of [instruction] at byte [place] if a handler that begins behind it serves it on a brick, otherwise null. */
    fun lengthOf(instruction: Instruction, place: Int): Int? {
        val length = instruction.next - place
        val isCall = instruction.opcode in Opcode.INVOKEVIRTUAL..Opcode.INVOKESTATIC
        return length.takeIf { it == SINGLE_BYTE || (it == CALL && isCall) }
    }
}
