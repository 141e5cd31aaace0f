package robotran.tinyvm.link

/** Thrown when an instruction does not fit the types of its operands or locals. */
internal class UnsoundCode : RuntimeException()

internal fun unsound(): Nothing = throw UnsoundCode()

/** The verifier's types of all locals and operands before an instruction; see [VerificationType]. */
internal class FrameState(private val locals: IntArray, private val operands: IntArray, depth: Int) {
    /** The number of operand words. */
    var depth: Int = depth
        private set

    fun copy() = FrameState(locals.copyOf(), operands.copyOf(), depth)

    fun push(value: Int) {
        if (depth == operands.size) unsound()
        operands[depth++] = value
    }

    /** Pushes a value and, if it is wide, its second word. */
    fun pushValue(value: Int) {
        push(value)
        if (VerificationType.isWide(value)) push(VerificationType.SECOND_WORD)
    }

    fun pop(): Int {
        if (depth == 0) unsound()
        return operands[--depth]
    }

    /** Pops a value of exactly the type [value], which must not be a reference. */
    fun popValue(value: Int) {
        if (VerificationType.isWide(value) && pop() != VerificationType.SECOND_WORD) unsound()
        if (pop() != value) unsound()
    }

    /** Pops a one-word value. */
    fun popSingle(): Int = pop().also {
        if (VerificationType.isWide(it) || it == VerificationType.SECOND_WORD || it == VerificationType.UNUSABLE) {
            unsound()
        }
    }

    fun popReference(): Int = pop().also { if (!VerificationType.isReference(it)) unsound() }

    /** Pops one two-word value or two one-word values; returns the lower word first. */
    fun popPair(): Pair<Int, Int> {
        if (depth > 0 && operands[depth - 1] == VerificationType.SECOND_WORD) {
            pop()
            return pop() to VerificationType.SECOND_WORD
        }
        val upper = popSingle()
        return popSingle() to upper
    }

    fun pushPair(pair: Pair<Int, Int>) {
        push(pair.first)
        push(pair.second)
    }

    fun local(slot: Int): Int = locals.getOrNull(slot) ?: unsound()

    /** Stores a value in [slot] and, if it is wide, in the next slot. */
    fun setLocal(slot: Int, value: Int) {
        setWord(slot, value)
        if (VerificationType.isWide(value)) setWord(slot + 1, VerificationType.SECOND_WORD)
    }

    private fun setWord(slot: Int, value: Int) {
        if (slot !in locals.indices) unsound()
        if (slot > 0 && VerificationType.isWide(locals[slot - 1]) && value != VerificationType.SECOND_WORD) {
            locals[slot - 1] = VerificationType.UNUSABLE
        }
        locals[slot] = value
    }

    /** Returns a copy with the caught [exception] as the only operand. */
    fun caught(exception: Int): FrameState {
        if (operands.isEmpty()) unsound()
        return FrameState(locals.copyOf(), IntArray(operands.size), 0).also { it.push(exception) }
    }

    /** Merges [other] into this state; returns true if that changed this state. */
    fun merge(other: FrameState, types: TypeRelations): Boolean {
        if (other.depth != depth) unsound()
        var changed = false
        for (slot in locals.indices) {
            val merged = types.merge(locals[slot], other.locals[slot])
            if (merged != locals[slot]) changed = true
            locals[slot] = merged
        }
        for (place in 0 until depth) {
            val merged = types.merge(operands[place], other.operands[place])
            if (merged != operands[place]) changed = true
            operands[place] = merged
        }
        return changed
    }
}
