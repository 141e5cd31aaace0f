package robotran.tinyvm.run

import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.MethodBody
import robotran.tinyvm.link.Operation

/** A method that is being executed; used again and again for others at the same depth. */
internal class Frame {
    lateinit var method: LinkedMethod
    lateinit var body: MethodBody

    /** The word of the code to be executed next. */
    var next = 0

    /** Where its locals begin on the thread's stack. */
    var base = 0

    /** Where its next operand goes. */
    var top = 0

    /** Whose monitor it leaves when it ends, 0 for none. */
    var lock = 0

    /** Whether it stands before a statement rather than in the middle of one. */
    val isBeforeStatement: Boolean get() = body.code.getOrNull(next) == Operation.STATEMENT

    /** The line of the statement it stands before. */
    val upcomingLine: Int get() = body.lineAt(next)

    /** The line it is at. */
    val line: Int get() = body.lineAt(if (next > 0) next - 1 else 0)
}
