package robotran.nqc.generate

import robotran.legofirmware.instructions.Opcode
import robotran.nqc.tree.LeaveKind

/** Where `break`, `continue` and `return` lead, and what they have to end on their way. */
internal class FlowContext(private val emitter: Emitter) {
    /** What a statement watches over while its body runs, and the instruction that ends it. */
    enum class Guard(val exit: Opcode) {
        MONITOR(Opcode.MONEX),
        ACQUIRE(Opcode.MONAX),
    }

    /** The targets of each kind, the innermost last; null where a function begins. */
    private val targets: Map<LeaveKind, MutableList<Label?>> = LeaveKind.entries.associateWith { mutableListOf(null) }

    /** How many targets of each kind are outside of an active guard. */
    private val guards = mutableMapOf<Guard, Map<LeaveKind, Int>>()

    /** Generates [body] with a new target for each of [kinds], which [body] gets, too. */
    fun within(vararg kinds: LeaveKind, body: (List<Label>) -> Unit) {
        val labels = kinds.map { kind -> emitter.buffer.label().also { targets.getValue(kind) += it } }
        body(labels)
        kinds.forEach { targets.getValue(it).let { it.removeAt(it.lastIndex) } }
    }

    /** Generates [body], which `break` and `continue` cannot leave. */
    fun withinFunction(body: () -> Unit) {
        within(LeaveKind.RETURN) { (end) ->
            targets.getValue(LeaveKind.BREAK) += null
            targets.getValue(LeaveKind.CONTINUE) += null
            body()
            emitter.buffer.place(end)
            targets.getValue(LeaveKind.BREAK).let { it.removeAt(it.lastIndex) }
            targets.getValue(LeaveKind.CONTINUE).let { it.removeAt(it.lastIndex) }
        }
    }

    /** Jumps to the innermost target of [kind]; false if there is none. */
    fun leave(kind: LeaveKind): Boolean {
        val target = targets.getValue(kind).last() ?: return false
        for (guard in Guard.entries) {
            if (guards[guard]?.get(kind) == targets.getValue(kind).size) emitter.add(guard.exit)
        }
        emitter.jump(target)
        return true
    }

    /** Begins what [guard] watches over; false if it already does. */
    fun begin(guard: Guard): Boolean {
        if (guard in guards) return false
        guards[guard] = targets.mapValues { it.value.size }
        return true
    }

    fun end(guard: Guard) {
        guards.remove(guard)
    }
}
