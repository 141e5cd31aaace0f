package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.link.Operation
import robotran.tinyvm.link.lengthOf

/** How a brick enters the handler of an exception. */
internal enum class HandlerEntry {
    NORMAL,

    /**
     * The instruction that failed puts its result, null, in place of the exception. Source: leJOS `op_arrays.hc`,
     * newarray and multianewarray.
     */
    WITHOUT_EXCEPTION,

    /**
     * The instruction that failed goes on to the next byte, which is now in the handler. So the handler does not store the
     * exception. Source: leJOS `op_objects.hc`, checkcast.
     */
    LATE,
}

/** What the handlers of exceptions are given. */
internal class HandlerEntries(private val machine: VirtualMachine) {
    /** What the handler that [thread] is about to begin is given for [exception]: 0 for null. */
    fun given(thread: VmThread, exception: Int, entry: HandlerEntry): Int {
        if (machine.model.isExact || entry == HandlerEntry.NORMAL) return exception
        val frame = thread.frame
        val store = storeOf(frame) ?: return exception
        val local = frame.body.code[store + 1]
        val owner = frame.method.owner
        if (owner.isOfProgram &&
            isRead(local, frame.body.code, store)
        ) {
            machine.warnings.add(Quirk.LOST_EXCEPTION, frame.upcomingLine, owner.sourceFile)
        }
        return when {
            !machine.model.hasQuirks -> exception
            entry == HandlerEntry.WITHOUT_EXCEPTION -> 0
            else -> held(thread.stack[frame.base + local], exception)
        }
    }

    /** Where the handler that [frame] is about to begin stores the exception in a variable, null if it drops it. */
    private fun storeOf(frame: Frame): Int? {
        val code = frame.body.code
        val isStatement = code[frame.next] == Operation.STATEMENT
        val first = if (isStatement) frame.next + lengthOf(Operation.STATEMENT) else frame.next
        return first.takeIf { code[it] == Operation.STORE }
    }

    /** Whether [code] reads the variable [local] behind [store], before the next value is stored in it. */
    private fun isRead(local: Int, code: IntArray, store: Int): Boolean {
        var at = store + lengthOf(Operation.STORE)
        while (at < code.size) {
            if (code[at] == Operation.LOAD && code[at + 1] == local) return true
            if (code[at] == Operation.STORE && code[at + 1] == local) return false
            at += lengthOf(code[at])
        }
        return false
    }

    /**
     * What a variable keeps that holds [word] and should get [exception]. A brick takes any word for an exception. Here it
     * must be one of the same class, otherwise the variable becomes null.
     */
    private fun held(word: Int, exception: Int): Int {
        val isException = machine.heap.isObject(word) && machine.heap.typeOf(word) === machine.heap.typeOf(exception)
        return if (isException) word else 0
    }
}
