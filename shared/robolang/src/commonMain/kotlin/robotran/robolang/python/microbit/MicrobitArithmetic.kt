package robotran.robolang.python.microbit

import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonArithmetic
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.primary
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement

/**
 * Counts exactly as Robolang does: where Python's own operators might not, with functions that know the line, so that a
 * mistake is told as in Robolang.
 */
internal class MicrobitArithmetic(private val context: PythonContext) : PythonArithmetic {
    private val expressions by lazy(LazyThreadSafetyMode.NONE) { context.expressions }
    private val program = context.program
    private val uses = context.uses

    /** Within which limits numbers are. */
    val ranges by lazy(LazyThreadSafetyMode.NONE) { Ranges(context) }

    override fun checked(number: Long, expression: Expression): String = "$number"

    override fun whole(text: PythonText, expression: Expression): PythonText =
        if (ranges.unlimited(expression).fitsWord) text else call(MicrobitHelper.WRAP, text.text)

    private fun call(helper: MicrobitHelper, vararg arguments: String): PythonText =
        primary("${uses.use(helper)}(${arguments.joinToString()})")

    private fun lineOf(expression: Expression): String = "${expression.range.line}"

    private fun isWhole(expression: Expression): Boolean = expressions.typeOf(expression) == ValueType.WHOLE

    override fun quotient(expression: Expression.Binary): PythonText = when {
        !isWhole(expression) -> decimalQuotient(expression)
        isPlain(expression) -> expressions.joined(expression, "//", PythonStrength.PRODUCT)
        // The smallest number divided by -1 is itself.
        isSmallest(expression.left) && ranges.of(expression.right).min <= -1 ->
            call(MicrobitHelper.WRAP, withLine(MicrobitHelper.DIVIDE, expression).text)

        else -> withLine(MicrobitHelper.DIVIDE, expression)
    }

    private fun isSmallest(value: Expression): Boolean = ranges.of(value).min == Span.WORD.min

    private fun decimalQuotient(expression: Expression.Binary): PythonText {
        val divisor = expression.right
        val isSafe = expressions.known(divisor)?.let { it.decimal != 0f }
            ?: (isWhole(divisor) && ranges.of(divisor).let { it.min > 0 || it.max < 0 })
        if (isSafe) return expressions.joined(expression, "/", PythonStrength.PRODUCT)
        return call(MicrobitHelper.QUOTIENT, expressions.arguments(listOf(expression.left, divisor)))
    }

    override fun remainder(expression: Expression.Binary): PythonText = when {
        !isWhole(expression) -> call(
            MicrobitHelper.DECIMAL_REMAINDER,
            expressions.arguments(listOf(expression.left, expression.right)),
        )

        isPlain(expression) -> expressions.joined(expression, "%", PythonStrength.PRODUCT)
        else -> withLine(MicrobitHelper.REMAINDER, expression)
    }

    /** Whether Python divides alike: nothing is below 0, and the right side is not 0. */
    private fun isPlain(expression: Expression.Binary): Boolean =
        ranges.of(expression.left).min >= 0 && ranges.of(expression.right).min > 0

    private fun withLine(helper: MicrobitHelper, expression: Expression.Binary): PythonText = call(
        helper,
        expressions.arguments(listOf(expression.left, expression.right)),
        lineOf(expression.right),
    )

    override fun element(expression: Expression.ListElement): PythonText {
        val list = expressions.text(expression.list, PythonStrength.PRIMARY)
        val index = expressions.text(expression.index)
        if (ranges.isPlace(expression.index, expression.list)) return primary("$list[$index]")
        return call(MicrobitHelper.ITEM, list, index, lineOf(expression.index))
    }

    override fun setElement(list: Name, index: Expression, value: String): String {
        val symbol = program.symbolOf(list)
        val name = context.names.of(symbol)
        val place = expressions.text(index)
        if (ranges.isPlace(index, symbol)) return "$name[$place] = $value"
        return call(MicrobitHelper.PUT, name, place, value, lineOf(index)).text
    }

    override fun random(call: Expression.Call): PythonText {
        val (first, second) = call.arguments
        if (program.typeOf(call) == ValueType.DECIMAL) {
            return primary("${uses.import("random", "uniform")}(${expressions.arguments(call.arguments)})")
        }
        val from = (expressions.literal(first) as? NumberValue.Whole)?.value
        val to = (expressions.literal(second) as? NumberValue.Whole)?.value
        if (from == null || to == null) return call(MicrobitHelper.RANDOM, expressions.arguments(call.arguments))
        return primary("${uses.import("random", "randint")}(${minOf(from, to)}, ${maxOf(from, to)})")
    }

    override fun rootOrPower(builtIn: BuiltIn, call: Expression.Call, arguments: String): PythonText {
        val value = call.arguments[0]
        val isPositive = if (isWhole(value)) ranges.of(value).min >= 0 else expressions.isNeverBelow(value)
        if (builtIn == BuiltIn.SQRT) {
            if (isPositive) return primary("${uses.import("math", "sqrt")}($arguments)")
            return call(MicrobitHelper.ROOT, arguments, lineOf(call))
        }
        val exponent = (expressions.literal(call.arguments[1]) as? NumberValue.Whole)?.value ?: -1
        if (exponent >= 0) return primary("${uses.import("math", "pow")}($arguments)")
        return call(MicrobitHelper.POWER_OF, arguments, lineOf(call))
    }

    override fun times(loop: Statement.Repeat): String {
        val count = expressions.text(loop.count)
        if (ranges.of(loop.count).min >= 0) return "range($count)"
        return call(MicrobitHelper.TIMES, count, "${loop.range.line}").text
    }

    override fun count(loop: Statement.ForRange, arguments: String): String =
        call(MicrobitHelper.COUNT, arguments, "${loop.range.line}").text

    override fun step(loop: Statement.ForRange, step: String): String =
        call(MicrobitHelper.STEP, step, "${loop.range.line}").text
}
