package robotran.robolang.run

/** Collects instructions while a program is lowered. */
internal class Emitter {
    private val collected = ArrayList<Instruction>()

    val instructions: List<Instruction> get() = collected

    /** Where the next instruction will be. */
    val place: Int get() = collected.size

    fun emit(instruction: Instruction) {
        collected += instruction
    }

    fun statement(line: Int) = emit(Boundary.Statement(line))

    /** Puts [label] before the next instruction. */
    fun put(label: Label) {
        label.place = place
    }

    fun jump(label: Label) = emit { it.next = label.place }

    fun jumpIfFalse(label: Label) = emit { if (it.pop() == 0) it.next = label.place }

    fun jumpIfTrue(label: Label) = emit { if (it.pop() != 0) it.next = label.place }

    /** Takes [count] values from the stack. */
    fun drop(count: Int) = emit { it.drop(count) }
}

/** A place among the instructions that may not be known yet. */
internal class Label {
    var place = 0
}
