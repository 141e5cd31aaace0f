package robotran.robolang.python.writer

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression

/** Writes calls of the built-in functions. */
internal class PythonBuiltIns(
    private val expressions: PythonExpressions,
    private val uses: PythonUses,
    private val target: PythonTarget,
) {
    private fun maths(name: String): String = uses.import(target.mathsModule, name)

    fun call(builtIn: BuiltIn, call: Expression.Call): PythonText {
        val arguments = call.arguments
        return when (builtIn) {
            BuiltIn.RANDOM -> target.arithmetic.random(call)
            BuiltIn.ABS -> primary("abs(${expressions.text(arguments[0])})")
            BuiltIn.MIN, BuiltIn.MAX -> smallestOrLargest(builtIn, call)
            BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> rounded(builtIn, arguments[0])
            BuiltIn.SIN, BuiltIn.COS, BuiltIn.TAN -> ofAngle(builtIn, arguments[0])
            BuiltIn.ATAN2 -> primary(
                "${maths("degrees")}(${maths("atan2")}(${expressions.arguments(arguments)}))",
            )

            BuiltIn.SQRT, BuiltIn.POW -> {
                target.arithmetic.rootOrPower(builtIn, call, expressions.arguments(arguments))
            }

            BuiltIn.LENGTH -> primary("len(${expressions.text(arguments[0])})")
        }
    }

    /** Of a whole and a decimal number Robolang makes a decimal one. */
    private fun smallestOrLargest(builtIn: BuiltIn, call: Expression.Call): PythonText {
        val text = "${builtIn.text}(${expressions.arguments(call.arguments)})"
        val types = call.arguments.map { expressions.typeOf(it) }.distinct()
        return primary(if (types.size > 1) "float($text)" else text)
    }

    /** Python's own `round` takes 2.5 to 2. */
    private fun rounded(builtIn: BuiltIn, value: Expression): PythonText {
        val isWhole = expressions.typeOf(value) == ValueType.WHOLE
        if (isWhole) return primary(expressions.text(value, PythonStrength.PRIMARY))
        return when (builtIn) {
            BuiltIn.ROUND -> primary("${maths("floor")}(${expressions.text(value, PythonStrength.SUM)} + 0.5)")
            else -> primary("${maths(builtIn.text)}(${expressions.text(value)})")
        }
    }

    private fun ofAngle(builtIn: BuiltIn, angle: Expression): PythonText =
        primary("${maths(builtIn.text)}(${maths("radians")}(${expressions.text(angle)}))")
}
