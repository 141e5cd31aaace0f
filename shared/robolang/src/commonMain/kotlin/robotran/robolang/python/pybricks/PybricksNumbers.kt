package robotran.robolang.python.pybricks

import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.robot.roundAsPython
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.TimeUnit

/** Writes the whole numbers that Pybricks takes: written ones worked out here, decimal ones rounded where they are made. */
internal class PybricksNumbers(context: PythonContext) {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }

    /** [value] as a whole number. */
    fun whole(value: Expression): String = times(value, 1)

    /** [value] times [factor]. */
    fun times(value: Expression, factor: Int): String {
        val product = when (val literal = expressions.literal(value)) {
            is NumberValue.Whole -> literal.value.toLong() * factor
            is NumberValue.Decimal -> roundAsPython(literal.decimal.toDouble() * factor)
            null -> return computed(value, factor)
        }
        return expressions.arithmetic.checked(product, value)
    }

    private fun computed(value: Expression, factor: Int): String {
        val text = when (factor) {
            1 -> expressions.text(value)
            -1 -> negative(value)
            else -> "$factor * ${expressions.text(value, PythonStrength.UNARY)}"
        }
        return if (expressions.typeOf(value) == ValueType.DECIMAL) "round($text)" else text
    }

    private fun negative(value: Expression): String {
        val text = expressions.text(value, PythonStrength.UNARY)
        return if (text.startsWith("-")) "-($text)" else "-$text"
    }

    /** A duration; `wait` takes off what is left of a millisecond. */
    fun milliseconds(value: Expression, unit: TimeUnit): String {
        val factor = if (unit == TimeUnit.SECONDS) MILLISECONDS_PER_SECOND else 1
        val isDecimal = expressions.typeOf(value) == ValueType.DECIMAL && expressions.literal(value) == null
        if (!isDecimal) return times(value, factor)
        return if (factor ==
            1
        ) {
            expressions.text(value)
        } else {
            "$factor * ${expressions.text(value, PythonStrength.UNARY)}"
        }
    }

    private companion object {
        const val MILLISECONDS_PER_SECOND = 1000
    }
}
