package robotran.robolang.nqc

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.allStatements

/** Writes expressions as NQC, with the brackets that it needs. What it cannot write becomes 0 and a note. */
internal class NqcExpressions(
    private val program: CheckedProgram,
    private val names: NqcNames,
    private val lightPort: Int,
    private val recursive: RecursiveRoutines,
    private val lists: KnownLists,
    private val notes: TranslationNotes,
) {
    private val messages = notes.messages

    /** The decimal constants; NQC has no names for such numbers. */
    private val decimals: Map<Symbol, Expression.Number> = allStatements(program.tree)
        .filterIsInstance<Statement.Declare>()
        .filter { it.isConstant }
        .mapNotNull { (it.value as? Expression.Number)?.let { value -> program.symbolOf(it.name) to value } }
        .filter { (_, value) -> value.value is NumberValue.Decimal }
        .toMap()

    /** Calls of functions that must come before the statement: in NQC a function gives no value. */
    private var before = mutableListOf<String>()

    fun typeOf(expression: Expression): ValueType = when {
        expression is Expression.Number && expression.value is NumberValue.Whole -> ValueType.WHOLE
        expression is Expression.Number -> ValueType.DECIMAL
        else -> program.typeOf(expression)
    }

    /** What [write] returns, and the lines that must come before it. */
    fun <T> withCalls(write: () -> T): Pair<T, List<String>> {
        val outer = before
        before = mutableListOf()
        val result = write()
        val calls = before
        before = outer
        return result to calls
    }

    fun text(expression: Expression): String = text(expression, LOOSEST)

    /** [expression], with brackets unless it binds at least as tightly as [strength]. */
    fun text(expression: Expression, strength: Int): String {
        val (text, own) = written(bare(expression))
        return if (own < strength) "($text)" else text
    }

    /** [expression] without brackets; the number that it stands for, if it is a decimal constant. */
    fun bare(expression: Expression): Expression = when (expression) {
        is Expression.Brackets -> bare(expression.inner)
        is Expression.Variable -> decimals[program.symbolOf(expression.name)] ?: expression
        else -> expression
    }

    /** Whether [symbol] is a constant that every use writes down. */
    fun isWrittenDown(symbol: Symbol): Boolean = symbol in decimals

    private fun lost(expression: Expression, message: String): Pair<String, Int> {
        notes.lost(expression.range, message)
        return "0" to TIGHTEST
    }

    private fun written(expression: Expression): Pair<String, Int> = when (expression) {
        is Expression.Number -> number(expression)
        is Expression.BooleanLiteral -> "${expression.value}" to TIGHTEST
        is Expression.Variable -> variable(expression)
        is Expression.Unary -> unary(expression)
        is Expression.Binary -> binary(expression)
        is Expression.Call -> call(expression)
        is Expression.Sense -> sense(expression)
        is Expression.Brackets -> written(bare(expression))
        is Expression.ListElement -> element(expression)
        is Expression.ListOf -> lost(expression, messages.list())
        is Expression.ColourLiteral -> lost(expression, messages.otherBrick())
    }

    private fun number(expression: Expression.Number): Pair<String, Int> = when (val value = expression.value) {
        is NumberValue.Decimal -> lost(expression, messages.decimal())

        is NumberValue.Whole -> if (value.value in NUMBERS) {
            "${value.value}" to if (value.value < 0) UNARY else TIGHTEST
        } else {
            lost(expression, messages.numberTooLarge(value.value))
        }
    }

    private fun element(expression: Expression.ListElement): Pair<String, Int> {
        val list = bare(expression.list)
        if (list !is Expression.Variable || lists.sizeOf(list) == null) return lost(expression, messages.list())
        return "${names.of(program.symbolOf(list.name))}[${text(expression.index)}]" to TIGHTEST
    }

    private fun variable(expression: Expression.Variable): Pair<String, Int> {
        val symbol = program.symbolOf(expression.name)
        return when {
            symbol.type.isList -> lost(expression, messages.list())
            symbol.type == ValueType.DECIMAL -> lost(expression, messages.decimal())
            else -> names.of(symbol) to TIGHTEST
        }
    }

    private fun unary(expression: Expression.Unary): Pair<String, Int> {
        val operand = text(expression.operand, UNARY)
        val sign = if (expression.operator == UnaryOperator.NOT) "!" else "-"
        return (if (operand.startsWith("-")) "$sign($operand)" else sign + operand) to UNARY
    }

    private fun binary(expression: Expression.Binary): Pair<String, Int> {
        val (operator, strength) = OPERATORS.getValue(expression.operator)
        if (expression.operator.isComparison) scaled(expression, operator)?.let { return it to strength }
        val left = text(expression.left, strength)
        val (right, calls) = withCalls { text(expression.right, strength + 1) }
        val isLogical = expression.operator == BinaryOperator.AND || expression.operator == BinaryOperator.OR
        if (isLogical && calls.isNotEmpty()) notes.changed(expression.right.range, messages.alwaysCalled())
        before += calls
        return "$left $operator $right" to strength
    }

    /** A comparison of the timer or the battery, which the brick measures in whole parts of their unit. */
    private fun scaled(expression: Expression.Binary, operator: String): String? {
        val left = bare(expression.left)
        val right = bare(expression.right)
        val isMirrored = measured(right) != null
        val sense = measured(if (isMirrored) right else left) ?: return null
        val other = if (isMirrored) left else right
        val (value, factor) = when (sense) {
            Sense.Battery -> "BatteryLevel()" to MILLIVOLTS
            else -> if (isWholeTimes(other, TENTHS)) "Timer(0)" to TENTHS else "FastTimer(0)" to HUNDREDTHS
        }
        val limit = times(other, factor)
        return if (isMirrored) "$limit $operator $value" else "$value $operator $limit"
    }

    private fun measured(expression: Expression): Sense? =
        (expression as? Expression.Sense)?.sense?.takeIf { it == Sense.Timer || it == Sense.Battery }

    private fun isWholeTimes(expression: Expression, factor: Int): Boolean {
        val value = (expression as? Expression.Number)?.value?.decimal ?: return true
        val product = value * factor
        return product - product.toInt() in -ALMOST..ALMOST
    }

    /** [expression] times [factor], for a duration in parts of its unit. Decimal numbers can only be written down. */
    fun times(expression: Expression, factor: Int): String {
        val bare = bare(expression)
        if (bare !is Expression.Number) return "${text(bare, PRODUCT)} * $factor"
        val product = bare.value.decimal.toDouble() * factor
        val rounded = (if (product < 0) product - HALF else product + HALF).toInt()
        if (rounded !in NUMBERS) {
            notes.lost(bare.range, messages.numberTooLarge(rounded))
            return "0"
        }
        return "$rounded"
    }

    private fun call(expression: Expression.Call): Pair<String, Int> {
        val symbol = program.symbolOf(expression.name)
        val builtIn = if (symbol.declaredAt == null) BuiltIn.of(expression.name.key) else null
        if (builtIn != null) return builtIn(builtIn, expression)
        if (symbol.type == ValueType.DECIMAL || symbol.type.isList) return lost(expression, messages.decimal())
        if (recursive.isCalledBy(expression.name)) return lost(expression, messages.recursion(expression.name.text))
        val result = names.local("result")
        val arguments = listOf(result) + expression.arguments.map { text(it) }
        before += "int $result;"
        before += "${names.of(symbol)}(${arguments.joinToString()});"
        return result to TIGHTEST
    }

    private fun builtIn(builtIn: BuiltIn, expression: Expression.Call): Pair<String, Int> {
        if (typeOf(expression) == ValueType.DECIMAL) return lost(expression, messages.decimal())
        val arguments = expression.arguments
        return when (builtIn) {
            BuiltIn.ABS -> "abs(${text(arguments[0])})" to TIGHTEST

            BuiltIn.MIN -> "(${text(arguments[0], SUM)} < ${text(arguments[1], SUM)} ? " +
                "${text(arguments[0], SUM)} : ${text(arguments[1], SUM)})" to TIGHTEST

            BuiltIn.MAX -> "(${text(arguments[0], SUM)} > ${text(arguments[1], SUM)} ? " +
                "${text(arguments[0], SUM)} : ${text(arguments[1], SUM)})" to TIGHTEST

            BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> if (typeOf(arguments[0]) == ValueType.WHOLE) {
                written(bare(arguments[0]))
            } else {
                lost(expression, messages.decimal())
            }

            BuiltIn.RANDOM -> random(arguments[0], arguments[1]) to SUM

            BuiltIn.LENGTH -> lists.sizeOf(bare(arguments[0]))?.let { "$it" to TIGHTEST }
                ?: lost(expression, messages.list())

            else -> lost(expression, messages.builtIn(builtIn.text))
        }
    }

    private fun random(from: Expression, to: Expression): String {
        val first = wholeOf(from)
        val last = wholeOf(to)
        return if (first != null && last != null) {
            val lowest = minOf(first, last)
            val most = maxOf(first, last) - lowest
            if (lowest == 0) "Random($most)" else "$lowest + Random($most)"
        } else {
            "${text(from, SUM)} + Random(32767) % (${text(to, SUM)} - ${text(from, PRODUCT)} + 1)"
        }
    }

    /** The value of a written whole number; null for anything else. */
    fun wholeOf(expression: Expression): Int? =
        ((bare(expression) as? Expression.Number)?.value as? NumberValue.Whole)?.value?.takeIf { it in NUMBERS }

    private fun sense(expression: Expression.Sense): Pair<String, Int> = when (val sense = expression.sense) {
        Sense.LeftBumper -> "SENSOR_1 == 1" to EQUALITY
        Sense.RightBumper -> "SENSOR_3 == 1" to EQUALITY
        Sense.Light -> "SENSOR_$lightPort" to TIGHTEST
        is Sense.Sensor -> "SENSOR_${sense.port}" to TIGHTEST
        Sense.Timer, Sense.Battery -> lost(expression, messages.decimal())
        is Sense.Button -> lost(expression, messages.button())
        Sense.Distance, Sense.Colour, Sense.Loudness, is Sense.Turned -> lost(expression, messages.otherBrick())
    }

    companion object {
        /** How tightly the operators of NQC bind. */
        private const val LOOSEST = 0
        private const val EQUALITY = 6
        private const val SUM = 9
        private const val PRODUCT = 10
        private const val UNARY = 11
        private const val TIGHTEST = 12

        private val NUMBERS = -32768..32767
        private const val TENTHS = 10
        const val HUNDREDTHS = 100
        private const val MILLIVOLTS = 1000
        private const val HALF = 0.5
        private const val ALMOST = 0.001f

        private val OPERATORS = mapOf(
            BinaryOperator.OR to ("||" to 1),
            BinaryOperator.AND to ("&&" to 2),
            BinaryOperator.EQUAL to ("==" to EQUALITY),
            BinaryOperator.NOT_EQUAL to ("!=" to EQUALITY),
            BinaryOperator.LESS to ("<" to 7),
            BinaryOperator.LESS_OR_EQUAL to ("<=" to 7),
            BinaryOperator.GREATER to (">" to 7),
            BinaryOperator.GREATER_OR_EQUAL to (">=" to 7),
            BinaryOperator.PLUS to ("+" to SUM),
            BinaryOperator.MINUS to ("-" to SUM),
            BinaryOperator.TIMES to ("*" to PRODUCT),
            BinaryOperator.DIVIDE to ("/" to PRODUCT),
            BinaryOperator.MOD to ("%" to PRODUCT),
        )
    }
}
