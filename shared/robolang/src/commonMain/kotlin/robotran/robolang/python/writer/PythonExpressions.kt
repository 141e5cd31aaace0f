package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.allStatements

/** Writes expressions as Python, with the pupil's brackets and those that Python needs. */
internal class PythonExpressions(
    private val program: CheckedProgram,
    private val names: PythonNames,
    uses: PythonUses,
    private val target: PythonTarget,
) {
    val arithmetic: PythonArithmetic = target.arithmetic
    private val signs = Signs(program)
    private val builtIns = PythonBuiltIns(this, uses, target)
    private val constants: Map<Symbol, Expression.Number> = allStatements(program.tree)
        .filterIsInstance<Statement.Declare>()
        .filter { it.isConstant && it.value is Expression.Number }
        .associate { program.symbolOf(it.name) to it.value as Expression.Number }

    fun typeOf(expression: Expression): ValueType = when {
        expression is Expression.Number && expression.value is NumberValue.Whole -> ValueType.WHOLE
        expression is Expression.Number -> ValueType.DECIMAL
        else -> program.typeOf(expression)
    }

    fun isNeverBelow(expression: Expression): Boolean = signs.isNeverBelow(expression)

    /** [expression] without brackets around all of it. */
    fun text(expression: Expression): String = written(bare(expression)).text

    /** [expression], with brackets unless it binds at least as tightly as [strength]. */
    fun text(expression: Expression, strength: Int): String = written(expression).atLeast(strength)

    /** The same inside another sum, difference or product of whole numbers, which is checked as a whole. */
    private fun part(expression: Expression, strength: Int, isPart: Boolean): String {
        val bare = bare(expression)
        if (!isPart || bare !is Expression.Binary || !isSum(bare)) return text(expression, strength)
        val inner = joined(bare, bare.operator.text, bare.operator.strength)
        return if (expression is Expression.Brackets) "(${inner.text})" else inner.atLeast(strength)
    }

    /** Whether [expression] is a sum, a difference or a product of whole numbers. */
    private fun isSum(expression: Expression.Binary): Boolean =
        expression.operator in SUMS && program.typeOf(expression) == ValueType.WHOLE

    /** [expression] for a place of the type [wanted]: a whole number becomes a decimal one. */
    fun text(expression: Expression, wanted: ValueType): String {
        val isWhole = typeOf(expression) == ValueType.WHOLE
        if (wanted == ValueType.LIST_OF_DECIMAL) return listText(expression)
        if (wanted != ValueType.DECIMAL || !isWhole) return text(expression)
        val literal = (bare(expression) as? Expression.Number)?.value as? NumberValue.Whole
        return if (literal != null) "${literal.value}.0" else "float(${text(expression)})"
    }

    private fun listText(expression: Expression): String {
        val list = bare(expression) as? Expression.ListOf ?: return text(expression)
        return list.elements.joinToString(prefix = "[", postfix = "]") { text(it, ValueType.DECIMAL) }
    }

    fun arguments(values: List<Expression>): String = values.joinToString { text(it) }

    /** The arguments of a call of [routine], each of the type of its parameter. */
    fun arguments(routine: Symbol, values: List<Expression>): String {
        val declared = program.tree.routines.firstOrNull { program.symbolOf(it.name) == routine }
        val types = declared?.parameters?.map { program.symbolOf(it).type }.orEmpty()
        return values.withIndex().joinToString { (place, value) ->
            types.getOrNull(place)?.let { text(value, it) } ?: text(value)
        }
    }

    /** The value of a written number, or of a constant with one; null for anything else. */
    fun literal(expression: Expression): NumberValue? = (bare(expression) as? Expression.Number)?.value

    /** The same, also of a constant. */
    fun known(expression: Expression): NumberValue? = when (val bare = bare(expression)) {
        is Expression.Number -> bare.value
        is Expression.Variable -> constants[program.symbolOf(bare.name)]?.value
        else -> null
    }

    /** Whether it costs and changes nothing to write [expression] twice. */
    fun isSimple(expression: Expression): Boolean =
        bare(expression).let { it is Expression.Number || it is Expression.Variable }

    fun bare(expression: Expression): Expression =
        if (expression is Expression.Brackets) bare(expression.inner) else expression

    /** The opposite of [condition] in natural Python. */
    fun opposite(condition: Expression): String {
        val bare = bare(condition)
        if (bare is Expression.Unary && bare.operator == UnaryOperator.NOT) return text(bare.operand)
        val operator = (bare as? Expression.Binary)?.let(::oppositeOf) ?: return negated(bare)
        return compared(bare, operator).text
    }

    private fun negated(condition: Expression): String = "not " + text(condition, PythonStrength.NOT)

    /** Comparisons of decimal numbers are not turned round, since all comparisons with nan are false. */
    private fun oppositeOf(comparison: Expression.Binary): BinaryOperator? {
        val areWhole = typeOf(comparison.left) == ValueType.WHOLE && typeOf(comparison.right) == ValueType.WHOLE
        val opposite = when (comparison.operator) {
            BinaryOperator.EQUAL -> return BinaryOperator.NOT_EQUAL
            BinaryOperator.NOT_EQUAL -> return BinaryOperator.EQUAL
            BinaryOperator.LESS -> BinaryOperator.GREATER_OR_EQUAL
            BinaryOperator.LESS_OR_EQUAL -> BinaryOperator.GREATER
            BinaryOperator.GREATER -> BinaryOperator.LESS_OR_EQUAL
            BinaryOperator.GREATER_OR_EQUAL -> BinaryOperator.LESS
            else -> return null
        }
        return opposite.takeIf { areWhole }
    }

    private fun written(expression: Expression): PythonText = when (expression) {
        is Expression.Number -> number(expression)
        is Expression.BooleanLiteral -> primary(if (expression.value) "True" else "False")
        is Expression.ColourLiteral -> target.colour(expression)
        is Expression.ListOf -> list(expression)
        is Expression.Variable -> primary(names.of(program.symbolOf(expression.name)))
        is Expression.ListElement -> arithmetic.element(expression)
        is Expression.Unary -> unary(expression)
        is Expression.Binary -> binary(expression)
        is Expression.Call -> call(expression)
        is Expression.Sense -> target.reading(expression)
        is Expression.Brackets -> inBrackets(expression)
    }

    private fun list(expression: Expression.ListOf): PythonText {
        val type = program.typeOf(expression)
        return primary(
            if (type ==
                ValueType.LIST_OF_DECIMAL
            ) {
                listText(expression)
            } else {
                "[${arguments(expression.elements)}]"
            },
        )
    }

    private fun number(expression: Expression.Number): PythonText {
        val text = when (val value = expression.value) {
            is NumberValue.Whole -> arithmetic.checked(value.value.toLong(), expression)
            is NumberValue.Decimal -> decimal(expression.text)
        }
        return PythonText(text, if (text.startsWith("-")) PythonStrength.UNARY else PythonStrength.PRIMARY)
    }

    /** A decimal number as it is typed; Python takes `.5`, but a teacher writes `0.5`. */
    private fun decimal(typed: String): String {
        val digits = typed.replace(" ", "").removePrefix("-")
        val text = if (digits.startsWith(".")) {
            "0$digits"
        } else if (digits.endsWith(".")) {
            "${digits}0"
        } else {
            digits
        }
        return if (typed.startsWith("-")) "-$text" else text
    }

    private fun unary(expression: Expression.Unary): PythonText = when (expression.operator) {
        UnaryOperator.NOT -> PythonText(negated(expression.operand), PythonStrength.NOT)

        UnaryOperator.MINUS -> {
            val operand = text(expression.operand, PythonStrength.UNARY)
            val text = PythonText(if (operand.startsWith("-")) "-($operand)" else "-$operand", PythonStrength.UNARY)
            if (program.typeOf(expression) == ValueType.WHOLE) arithmetic.whole(text, expression) else text
        }
    }

    private fun binary(expression: Expression.Binary): PythonText = when {
        expression.operator.isComparison -> compared(expression, expression.operator)
        expression.operator == BinaryOperator.DIVIDE -> arithmetic.quotient(expression)

        expression.operator == BinaryOperator.MOD -> arithmetic.remainder(expression)

        else -> {
            val text = joined(expression, expression.operator.text, expression.operator.strength)
            if (isSum(expression)) arithmetic.whole(text, expression) else text
        }
    }

    /** Both sides of [expression] with [operator] between. */
    fun joined(expression: Expression.Binary, operator: String, strength: Int): PythonText {
        val isSum = isSum(expression)
        val left = part(expression.left, strength, isSum)
        return PythonText("$left $operator ${part(expression.right, strength + 1, isSum)}", strength)
    }

    /** Both sides bind tighter than a comparison, so that no chain comes about. */
    private fun compared(expression: Expression.Binary, operator: BinaryOperator): PythonText {
        val left = text(expression.left, PythonStrength.SUM)
        return PythonText(
            "$left ${operator.text} ${text(expression.right, PythonStrength.SUM)}",
            PythonStrength.COMPARISON,
        )
    }

    private fun call(expression: Expression.Call): PythonText {
        val symbol = program.symbolOf(expression.name)
        val builtIn = if (symbol.declaredAt == null) BuiltIn.of(expression.name.key) else null
        return if (builtIn != null) builtIns.call(builtIn, expression) else call(symbol, expression.arguments)
    }

    /** A call of a routine of the program. */
    fun call(routine: Symbol, arguments: List<Expression>): PythonText =
        target.called(routine, "${names.of(routine)}(${arguments(routine, arguments)})")

    /** The pupil's brackets, unless what is in them has no operator. */
    private fun inBrackets(expression: Expression.Brackets): PythonText {
        val inner = written(bare(expression))
        return if (inner.strength >= PythonStrength.AWAIT) inner else primary("(${inner.text})")
    }

    private companion object {
        val SUMS = setOf(BinaryOperator.PLUS, BinaryOperator.MINUS, BinaryOperator.TIMES)
    }
}
