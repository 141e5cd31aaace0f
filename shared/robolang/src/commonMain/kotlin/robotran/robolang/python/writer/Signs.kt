package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.UnaryOperator

/**
 * Finds whole numbers that are never below 0: Python divides those as Robolang does, and a list has places for them.
 * What a variable, a parameter or a function can be comes from all lines that give it a value.
 */
internal class Signs(private val program: CheckedProgram) {
    private val values = ValueSources(program).values
    private val neverBelow: MutableSet<Symbol> = values.keys.filterTo(HashSet()) { it.type == ValueType.WHOLE }

    init {
        do {
            val negative = neverBelow.filter { symbol ->
                values.getValue(symbol).any { it == null || !isNeverBelow(it) }
            }
            neverBelow -= negative.toSet()
        } while (negative.isNotEmpty())
    }

    /** Whether the value of [expression] is never below 0. */
    fun isNeverBelow(expression: Expression): Boolean = when (expression) {
        is Expression.Number -> !expression.value.isNegative
        is Expression.Variable -> program.symbolOf(expression.name) in neverBelow
        is Expression.Brackets -> isNeverBelow(expression.inner)
        is Expression.Unary -> expression.operator == UnaryOperator.MINUS && isZero(expression.operand)
        is Expression.Binary -> ofBinary(expression)
        is Expression.Call -> ofCall(expression)
        is Expression.Sense -> expression.sense !is Sense.Turned
        is Expression.BooleanLiteral, is Expression.ColourLiteral, is Expression.ListOf -> false
        is Expression.ListElement -> false
    }

    private fun isZero(expression: Expression): Boolean = (expression as? Expression.Number)?.value?.decimal == 0f

    private fun ofBinary(expression: Expression.Binary): Boolean = when (expression.operator) {
        BinaryOperator.PLUS, BinaryOperator.TIMES, BinaryOperator.DIVIDE -> {
            isNeverBelow(expression.left) && isNeverBelow(expression.right)
        }

        BinaryOperator.MOD -> isNeverBelow(expression.left)
        else -> false
    }

    private fun ofCall(call: Expression.Call): Boolean {
        val symbol = program.symbolOf(call.name)
        val builtIn = if (symbol.declaredAt == null) BuiltIn.of(call.name.key) else null
        return when (builtIn) {
            null -> symbol in neverBelow

            BuiltIn.ABS, BuiltIn.LENGTH, BuiltIn.SQRT -> true

            BuiltIn.MAX -> call.arguments.any { isNeverBelow(it) }

            BuiltIn.MIN, BuiltIn.RANDOM, BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> {
                call.arguments.all { isNeverBelow(it) }
            }

            BuiltIn.SIN, BuiltIn.COS, BuiltIn.TAN, BuiltIn.ATAN2, BuiltIn.POW -> false
        }
    }
}
