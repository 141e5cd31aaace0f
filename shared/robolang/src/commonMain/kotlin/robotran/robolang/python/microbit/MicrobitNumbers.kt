package robotran.robolang.python.microbit

import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.robot.Durations
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.TimeUnit

/** Writes the numbers that commands take: written ones are worked out here, as in the interpreter. */
internal class MicrobitNumbers(private val context: PythonContext, private val ranges: () -> Ranges) {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }
    private val uses = context.uses

    private fun isWhole(value: Expression) = expressions.typeOf(value) == ValueType.WHOLE

    /** Whether [value] is never below 0. */
    fun isPositive(value: Expression): Boolean =
        expressions.known(value)?.let { !it.isNegative } ?: (isWhole(value) && ranges().of(value).min >= 0)

    /** A duration in whole milliseconds; a negative one ends the program. */
    fun milliseconds(value: Expression, unit: TimeUnit, durations: Durations): String {
        val literal = expressions.literal(value)
        if (literal != null && !literal.isNegative) return "${durations.ofWait(literal, unit)}"
        val text = if (unit == TimeUnit.SECONDS) {
            "$MILLISECONDS_PER_SECOND * ${expressions.text(value, PythonStrength.UNARY)}"
        } else {
            expressions.text(value)
        }
        if (isWhole(value) && isPositive(value)) return text
        return "${uses.use(MicrobitHelper.MILLISECONDS)}($text, ${value.range.line})"
    }

    /** The duration of a tone, in hundredths of a second. */
    fun ofTone(value: Expression, durations: Durations): String {
        val literal = expressions.literal(value)
        if (literal != null && !literal.isNegative) return "${durations.ofTone(literal) * MILLISECONDS_PER_HUNDREDTH}"
        val text = expressions.text(value, PythonStrength.UNARY)
        if (isWhole(value) && isPositive(value)) return "$MILLISECONDS_PER_SECOND * $text"
        val helper = uses.use(MicrobitHelper.MILLISECONDS)
        return "$MILLISECONDS_PER_HUNDREDTH * $helper($HUNDREDTHS_PER_SECOND * $text, ${value.range.line})"
    }

    /** [value] rounded, a half upwards. */
    fun whole(value: Expression): String = when (val literal = expressions.literal(value)) {
        is NumberValue.Whole -> "${literal.value}"

        else -> if (isWhole(value)) {
            expressions.text(value)
        } else {
            "${uses.import("math", "floor")}(${expressions.text(value, PythonStrength.SUM)} + 0.5)"
        }
    }

    /** A power from 0 to 7; another one ends the program. */
    fun power(value: Expression): String {
        val span = if (isWhole(value)) ranges().of(value) else Span.WORD
        if (span.min >= 0 && span.max <= MOST_POWER) return whole(value)
        return "${uses.use(MicrobitHelper.POWER)}(${whole(value)}, ${value.range.line})"
    }

    private companion object {
        const val MILLISECONDS_PER_SECOND = 1000
        const val HUNDREDTHS_PER_SECOND = 100
        const val MILLISECONDS_PER_HUNDREDTH = 10
        const val MOST_POWER = 7.0
    }
}
