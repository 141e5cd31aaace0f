package robotran.tinyvm.run

import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.MethodBody
import robotran.tinyvm.link.Operation

/** The activation of a method; reused for later calls at the same depth. */
internal class Frame {
    lateinit var method: LinkedMethod
        private set
    lateinit var body: MethodBody
        private set

    /** Index of the next code word to execute. */
    var next = 0

    /** Index of its first local on the thread's stack. */
    var base = 0

    /** Index of its next free operand on the thread's stack. */
    var top = 0

    /** The monitor to exit when the method ends, 0 for none. */
    var lock = 0

    /**
     * Starts [called], which has a body and whose first local is at [base] of [stack]. The locals that are not arguments
     * become 0, so that no remains of earlier calls keep objects from being freed.
     */
    fun begin(called: LinkedMethod, base: Int, stack: IntArray) {
        if (!::method.isInitialized || method !== called) {
            method = called
            body = called.body ?: error("${called.name} has no code")
        }
        next = 0
        this.base = base
        top = base + called.maxLocals
        lock = 0
        for (local in base + called.argumentWords until top) stack[local] = 0
    }

    /** Whether the next operation begins a statement. */
    val isBeforeStatement: Boolean get() = body.code.getOrNull(next) == Operation.STATEMENT

    /** The line of the next operation. */
    val upcomingLine: Int get() = body.lineAt(next)

    /** The byte of the current operation in the class file. */
    val byte: Int get() = body.byteAt(if (next > 0) next - 1 else 0)

    /** The line of the current operation. */
    val line: Int get() = body.lineAt(if (next > 0) next - 1 else 0)
}
