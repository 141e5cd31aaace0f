package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.UnaryOperator

/** Writes expressions as Java, with the pupil's brackets and those that Java needs. */
internal class JavaExpressions(
    private val program: CheckedProgram,
    private val names: JavaNames,
    private val helpers: UsedHelpers,
    private val sensors: JavaSensors,
) {
    fun typeOf(expression: Expression): ValueType = when {
        expression is Expression.Number && expression.value is NumberValue.Whole -> ValueType.WHOLE
        expression is Expression.Number -> ValueType.DECIMAL
        else -> program.typeOf(expression)
    }

    /** [expression] without brackets around all of it. */
    fun text(expression: Expression): String = written(withoutBrackets(expression)).text

    /** [expression], with brackets unless it binds at least as tightly as [strength]. */
    fun text(expression: Expression, strength: Int): String = written(expression).atLeast(strength)

    /** The negation of [condition] in natural Java. */
    fun opposite(condition: Expression): String {
        val bare = withoutBrackets(condition)
        if (bare is Expression.Unary && bare.operator == UnaryOperator.NOT) return text(bare.operand)
        val operator = (bare as? Expression.Binary)?.let(::oppositeOf) ?: return negated(bare)
        return binary(bare, operator).text
    }

    /** Java for `not` [condition]. */
    private fun negated(condition: Expression): String = "!" + text(condition, OperatorPrecedence.UNARY)

    /** Comparisons of decimal numbers are not inverted, since all comparisons with NaN are false. */
    private fun oppositeOf(comparison: Expression.Binary): BinaryOperator? {
        val areWhole = typeOf(comparison.left) == ValueType.WHOLE && typeOf(comparison.right) == ValueType.WHOLE
        return when (comparison.operator) {
            BinaryOperator.EQUAL -> BinaryOperator.NOT_EQUAL
            BinaryOperator.NOT_EQUAL -> BinaryOperator.EQUAL
            BinaryOperator.LESS -> BinaryOperator.GREATER_OR_EQUAL.takeIf { areWhole }
            BinaryOperator.LESS_OR_EQUAL -> BinaryOperator.GREATER.takeIf { areWhole }
            BinaryOperator.GREATER -> BinaryOperator.LESS_OR_EQUAL.takeIf { areWhole }
            BinaryOperator.GREATER_OR_EQUAL -> BinaryOperator.LESS.takeIf { areWhole }
            else -> null
        }
    }

    /** The arguments of a call, separated by commas. */
    fun arguments(values: List<Expression>): String = values.joinToString(", ") { text(it) }

    private fun written(expression: Expression): JavaText = when (expression) {
        is Expression.Number -> number(expression)
        is Expression.BooleanLiteral -> primary(expression.value.toString())
        is Expression.ColourLiteral -> primary("Color.${expression.colour.name}")
        is Expression.ListOf -> JavaText(list(expression), OperatorPrecedence.UNARY)
        is Expression.Variable -> primary(names.of(program.symbolOf(expression.name)))

        is Expression.ListElement -> primary(
            "${text(expression.list, OperatorPrecedence.PRIMARY)}[${text(expression.index)}]",
        )

        is Expression.Unary -> unary(expression)
        is Expression.Binary -> binary(expression)
        is Expression.Call -> call(expression)
        is Expression.Sense -> sense(expression.sense)
        is Expression.Brackets -> inBrackets(expression)
    }

    private fun list(expression: Expression.ListOf): String =
        "new ${javaType(typeOf(expression).element)}[] ${elements(expression)}"

    /** The elements of a new list in braces. */
    fun elements(expression: Expression.ListOf): String = expression.elements.joinToString(", ", "{", "}") { text(it) }

    private fun unary(expression: Expression.Unary): JavaText = when (expression.operator) {
        UnaryOperator.NOT -> JavaText(negated(expression.operand), OperatorPrecedence.UNARY)

        UnaryOperator.MINUS -> {
            val operand = text(expression.operand, OperatorPrecedence.UNARY)
            JavaText(if (operand.startsWith("-")) "-($operand)" else "-$operand", OperatorPrecedence.UNARY)
        }
    }

    private fun binary(expression: Expression.Binary): JavaText {
        if (expression.operator == BinaryOperator.MOD && typeOf(expression) == ValueType.DECIMAL) {
            return primary("${helpers.use(JavaHelper.REMAINDER)}(${text(expression.left)}, ${text(expression.right)})")
        }
        return binary(expression, expression.operator)
    }

    private fun binary(expression: Expression.Binary, operator: BinaryOperator): JavaText {
        val strength = OperatorPrecedence.of(operator)
        val left = text(expression.left, strength)
        val right = text(expression.right, strength + 1)
        return JavaText("$left ${OperatorPrecedence.textOf(operator)} $right", strength)
    }

    private fun call(expression: Expression.Call): JavaText {
        val symbol = program.symbolOf(expression.name)
        val builtIn = if (symbol.declaredAt == null) BuiltIn.of(expression.name.key) else null
        if (builtIn == null) return primary("${names.of(symbol)}(${arguments(expression.arguments)})")
        if (builtIn == BuiltIn.LENGTH) {
            return primary("${text(expression.arguments.single(), OperatorPrecedence.PRIMARY)}.length")
        }
        return builtIn(builtIn, expression)
    }

    private fun builtIn(builtIn: BuiltIn, expression: Expression.Call): JavaText {
        val values = arguments(expression.arguments)
        val isWhole = typeOf(expression) == ValueType.WHOLE
        return when (builtIn) {
            BuiltIn.ABS, BuiltIn.MIN, BuiltIn.MAX -> {
                val result = "Math.${builtIn.text}($values)"
                if (isWhole) primary(result) else JavaText("(float) $result", OperatorPrecedence.UNARY)
            }

            // A whole number needs no rounding.
            BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> {
                if (typeOf(expression.arguments.single()) == ValueType.WHOLE) {
                    written(withoutBrackets(expression.arguments.single()))
                } else {
                    primary("${helpers.use(JavaHelper.of(builtIn))}($values)")
                }
            }

            BuiltIn.RANDOM -> {
                primary("${helpers.use(if (isWhole) JavaHelper.RANDOM else JavaHelper.RANDOM_DECIMAL)}($values)")
            }

            else -> primary("${helpers.use(JavaHelper.of(builtIn))}($values)")
        }
    }

    private fun sense(sense: Sense): JavaText = primary(sensors.valueOf(sense, helpers))

    /** The pupil's brackets, unless the operand is atomic. */
    private fun inBrackets(expression: Expression.Brackets): JavaText {
        val inner = written(withoutBrackets(expression))
        return if (inner.strength == OperatorPrecedence.PRIMARY) inner else primary("(${inner.text})")
    }

    private fun withoutBrackets(expression: Expression): Expression =
        if (expression is Expression.Brackets) withoutBrackets(expression.inner) else expression

    private fun primary(text: String) = JavaText(text, OperatorPrecedence.PRIMARY)
}

/** Java code with the precedence of its outermost operator. */
private class JavaText(val text: String, val strength: Int) {
    fun atLeast(wanted: Int): String = if (strength < wanted) "($text)" else text
}

/** A number literal in Java; whole numbers without leading zeros, which would make them octal. */
private fun number(expression: Expression.Number): JavaText {
    val text = when (val value = expression.value) {
        is NumberValue.Whole -> value.value.toString()
        is NumberValue.Decimal -> decimal(expression.text, value.decimal)
    }
    return JavaText(text, if (text.startsWith("-")) OperatorPrecedence.UNARY else OperatorPrecedence.PRIMARY)
}

private fun decimal(typed: String, value: Float): String {
    val sign = if (typed.startsWith("-")) "-" else ""
    val digits = typed.removePrefix("-").trim()
    return sign + (if (value == 0f) "0.0" else digits) + "f"
}

/** The Java type for [type]. */
internal fun javaType(type: ValueType): String = when (type) {
    ValueType.WHOLE, ValueType.COLOUR -> "int"
    ValueType.DECIMAL -> "float"
    ValueType.TRUTH -> "boolean"
    ValueType.LIST_OF_WHOLE -> "int[]"
    ValueType.LIST_OF_DECIMAL -> "float[]"
    ValueType.NOTHING -> "void"
}
