package robotran.tinyvm.link

/**
 * The operand stack while a block is compiled to [RegisterCode]. Locals and constants are put on the real stack only
 * where needed, since most instructions can use them where they are.
 *
 * @param firstRegister the register of the lowest operand.
 * @param instructions receives the instructions that put operands on the stack.
 */
internal class OperandStack(
    private val firstRegister: Int,
    private val instructions: MutableList<RegisterInstruction>,
) {
    private val operands = ArrayList<Operand>()

    /** The register after the topmost operand. */
    val end: Int get() = firstRegister + operands.size

    /** Starts with [depth] operands, all on the stack. */
    fun reset(depth: Int) {
        operands.clear()
        repeat(depth) { pushResult() }
    }

    /** Pushes an operand that the next instruction computes; returns the register to put it in. */
    fun pushResult(): Int = end.also { operands += Operand(Operand.ON_STACK, it) }

    fun pushLocal(local: Int) {
        operands += Operand(Operand.LOCAL, end, local)
    }

    fun pushConstant(value: Int) {
        operands += Operand(Operand.CONSTANT, end, value)
    }

    fun pop(): Operand = operands.removeAt(operands.lastIndex)

    /** Pops an operand and returns the register it is in. */
    fun popRegister(): Int = registerOf(pop())

    /** Pushes an operand of two words that the next instruction computes; returns the first register to put it in. */
    fun pushPair(): Int = pushResult().also { pushResult() }

    /** Pops an operand of two words and returns the first of the two registers it is in. */
    fun popPair(): Int {
        val high = pop()
        val low = pop()
        if (low.kind == Operand.LOCAL && high.kind == Operand.LOCAL && high.value == low.value + 1) return low.value
        if (low.kind != Operand.ON_STACK) put(low)
        if (high.kind != Operand.ON_STACK) put(high)
        return low.register
    }

    /** Pushes [operand], which was popped from the same place. */
    fun push(operand: Operand) {
        operands += if (operand.isConstant) Operand(Operand.ON_STACK, operand.register) else operand
    }

    /** Puts the popped [operand] on the stack; returns its register there. */
    fun putOnStack(operand: Operand): Int {
        put(operand)
        return operand.register
    }

    /** Pushes a copy of the operand that is [below] operands below the topmost. */
    fun pushCopy(below: Int) {
        val copied = operands[operands.lastIndex - below]
        when (copied.kind) {
            Operand.ON_STACK -> {
                instructions += RegisterInstruction(RegisterOperation.MOVE, pushResult(), copied.register)
            }

            else -> operands += Operand(copied.kind, end, copied.value)
        }
    }

    /** The register that [operand] is in; puts it on the stack if it is a constant. */
    fun registerOf(operand: Operand): Int {
        if (operand.kind == Operand.LOCAL) return operand.value
        if (operand.isConstant) put(operand)
        return operand.register
    }

    /** Whether an operand is still in [local]. */
    fun uses(local: Int): Boolean = operands.any { it.kind == Operand.LOCAL && it.value == local }

    /** Puts the operands on the stack that are still in [local], whose value is about to change. */
    fun rescue(local: Int) = putAll { it.kind == Operand.LOCAL && it.value == local }

    /**
     * Returns the register of the first of the topmost [count] operands, the object whose method is called. The call
     * puts it on the stack.
     */
    fun leaveReceiver(count: Int): Int {
        val index = operands.size - count
        val receiver = operands[index]
        if (receiver.kind == Operand.LOCAL) operands[index] = Operand(Operand.ON_STACK, receiver.register)
        return registerOf(receiver)
    }

    /** Puts all operands on the stack. */
    fun complete() = putAll { it.kind != Operand.ON_STACK }

    /** The operands that are not on the stack, as in the exit table of [RegisterCode]. */
    fun delayed(): IntArray = operands.filter { it.kind != Operand.ON_STACK }
        .flatMap { listOf(it.register, it.kind, it.value) }.toIntArray()

    private inline fun putAll(isWanted: (Operand) -> Boolean) {
        for (index in operands.indices) {
            val operand = operands[index]
            if (!isWanted(operand)) continue
            put(operand)
            operands[index] = Operand(Operand.ON_STACK, operand.register)
        }
    }

    private fun put(operand: Operand) {
        instructions += if (operand.isConstant) {
            RegisterInstruction.constant(operand.register, operand.value)
        } else {
            RegisterInstruction(RegisterOperation.MOVE, operand.register, operand.value)
        }
    }
}
