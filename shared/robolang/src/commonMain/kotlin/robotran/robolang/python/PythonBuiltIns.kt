package robotran.robolang.python

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue

/** Writes calls of the built-in functions. */
internal class PythonBuiltIns(private val expressions: PythonExpressions, private val uses: PythonUses) {
    fun call(builtIn: BuiltIn, call: Expression.Call): PythonText {
        val arguments = call.arguments
        return when (builtIn) {
            BuiltIn.RANDOM -> random(arguments[0], arguments[1])
            BuiltIn.ABS -> primary("abs(${expressions.text(arguments[0])})")
            BuiltIn.MIN, BuiltIn.MAX -> smallestOrLargest(builtIn, call)
            BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> rounded(builtIn, arguments[0])
            BuiltIn.SIN, BuiltIn.COS, BuiltIn.TAN -> ofAngle(builtIn, arguments[0])
            BuiltIn.ATAN2 -> primary(
                "${uses.maths("degrees")}(${uses.maths("atan2")}(${expressions.arguments(arguments)}))",
            )
            BuiltIn.SQRT, BuiltIn.POW -> primary("${uses.maths(builtIn.text)}(${expressions.arguments(arguments)})")
            BuiltIn.LENGTH -> primary("len(${expressions.text(arguments[0])})")
        }
    }

    /** Robolang takes the two limits in either order. */
    private fun random(first: Expression, second: Expression): PythonText {
        val from = whole(first)
        val to = whole(second)
        if (from != null && to != null) {
            return primary("${uses.import("urandom", "randint")}(${minOf(from, to)}, ${maxOf(from, to)})")
        }
        return primary("${uses.use(PythonHelper.RANDOM)}(${expressions.text(first)}, ${expressions.text(second)})")
    }

    private fun whole(expression: Expression): Int? = (expressions.literal(expression) as? NumberValue.Whole)?.value

    /** Of a whole and a decimal number Robolang makes a decimal one. */
    private fun smallestOrLargest(builtIn: BuiltIn, call: Expression.Call): PythonText {
        val text = "${builtIn.text}(${expressions.arguments(call.arguments)})"
        val types = call.arguments.map { expressions.typeOf(it) }.distinct()
        return primary(if (types.size > 1) "float($text)" else text)
    }

    /** Python's own `round` takes 2.5 to 2. */
    private fun rounded(builtIn: BuiltIn, value: Expression): PythonText {
        if (expressions.typeOf(value) ==
            ValueType.WHOLE
        ) {
            return primary(expressions.text(value, PythonStrength.PRIMARY))
        }
        return when (builtIn) {
            BuiltIn.ROUND -> primary("${uses.maths("floor")}(${expressions.text(value, PythonStrength.SUM)} + 0.5)")
            else -> primary("${uses.maths(builtIn.text)}(${expressions.text(value)})")
        }
    }

    private fun ofAngle(builtIn: BuiltIn, angle: Expression): PythonText =
        primary("${uses.maths(builtIn.text)}(${uses.maths("radians")}(${expressions.text(angle)}))")
}
