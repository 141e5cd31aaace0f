package robotran.tinyvm.run

import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.MethodBody
import robotran.tinyvm.link.Operation

/** The activation of a method; reused for later calls at the same depth. */
internal class Frame {
    lateinit var method: LinkedMethod
    lateinit var body: MethodBody

    /** Index of the next code word to execute. */
    var next = 0

    /** Index of its first local on the thread's stack. */
    var base = 0

    /** Index of its next free operand on the thread's stack. */
    var top = 0

    /** The monitor to exit when the method ends, 0 for none. */
    var lock = 0

    /** Starts [called], whose first local is at [base] and whose executable code is [code]. */
    fun begin(called: LinkedMethod, code: MethodBody, base: Int, lock: Int) {
        method = called
        body = code
        next = 0
        this.base = base
        top = base + called.maxLocals
        this.lock = lock
    }

    /** Whether the next operation begins a statement. */
    val isBeforeStatement: Boolean get() = body.code.getOrNull(next) == Operation.STATEMENT

    /** The line of the next operation. */
    val upcomingLine: Int get() = body.lineAt(next)

    /** The line of the current operation. */
    val line: Int get() = body.lineAt(if (next > 0) next - 1 else 0)
}
