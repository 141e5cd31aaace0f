package robotran.tinyvm.run

import robotran.tinyvm.link.BuiltInException

/** Divides integers by divisors outside 1..32767; the interpreter's loop handles the others itself. */
internal class Division(private val arithmetic: RcxArithmetic, private val calls: Calls) {
    /** Divides the two topmost operands of [frame], the innermost of [thread]. */
    fun execute(thread: VmThread, frame: Frame, isRemainder: Boolean) {
        val stack = thread.stack
        var divisor = stack[--frame.top]
        if (divisor != divisor.toShort().toInt()) divisor = arithmetic.largeDivisor(divisor)
        val dividend = stack[frame.top - 1]
        when (divisor) {
            0 -> calls.throwNew(thread, BuiltInException.ARITHMETIC)
            -1 -> stack[frame.top - 1] = if (isRemainder) 0 else -dividend
            else -> stack[frame.top - 1] = if (isRemainder) dividend % divisor else dividend / divisor
        }
    }
}
