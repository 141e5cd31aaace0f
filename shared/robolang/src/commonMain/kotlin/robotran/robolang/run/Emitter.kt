package robotran.robolang.run

import robotran.robolang.check.Symbol

/** Collects instructions while a program is lowered. */
internal class Emitter {
    private val collected = ArrayList<StackInstruction>()

    /** The variables in scope at the next instruction. */
    var known: KnownVariables? = null

    val instructions: List<StackInstruction> get() = collected

    /** The index of the next instruction. */
    val place: Int get() = collected.size

    fun emit(instruction: StackInstruction) {
        collected += instruction
    }

    fun statement(line: Int) = emit(Boundary.Statement(line, known))

    fun declare(symbol: Symbol) {
        known = KnownVariables(symbol, known)
    }

    /** Runs [lower] in a scope of its own. */
    inline fun inBlock(lower: () -> Unit) {
        val outside = known
        lower()
        known = outside
    }

    /** Puts [label] before the next instruction. */
    fun put(label: Label) {
        label.place = place
    }

    fun jump(label: Label) = emit { it.next = label.place }

    fun jumpIfFalse(label: Label) = emit { if (it.pop() == 0) it.next = label.place }

    fun jumpIfTrue(label: Label) = emit { if (it.pop() != 0) it.next = label.place }

    /** Pops [count] values from the stack. */
    fun drop(count: Int) = emit { it.drop(count) }
}

/** A jump target, which may not be known yet. */
internal class Label {
    var place = 0
}
