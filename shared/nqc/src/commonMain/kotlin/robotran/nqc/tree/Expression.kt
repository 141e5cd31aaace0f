package robotran.nqc.tree

import robotran.language.source.SourceRange

/** An expression. It never changes, so that functions can repeat it. */
internal sealed class Expression {
    abstract val range: SourceRange

    /** The expressions in it. */
    abstract val parts: List<Expression>

    /** Height of the tree, 1 without parts. */
    val height: Int by lazy(LazyThreadSafetyMode.PUBLICATION) { 1 + (parts.maxOfOrNull { it.height } ?: 0) }

    /** How many expressions its code is made of, at most [HEAVY]: some are evaluated twice. */
    val weight: Int by lazy(LazyThreadSafetyMode.PUBLICATION) {
        val times = if (this is Binary && operator == BinaryOperator.EXCLUSIVE_OR) 2 else 1
        minOf(HEAVY, 1 + times * parts.sumOf { it.weight })
    }

    /** Its value if it is constant, computed with 32 bits; null if not, or if it divides by 0. */
    val constant: Int? by lazy(LazyThreadSafetyMode.PUBLICATION) { fold(this) }

    /** Whether it is constant once the constant parameters of its function are known. */
    abstract val isPromisedConstant: Boolean

    data class Constant(val value: Int, override val range: SourceRange) : Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = true
    }

    /** A variable of the program or a parameter. */
    data class VariableUse(val variable: Variable, override val range: SourceRange) : Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = variable.parameter == ParameterKind.CONSTANT
    }

    /** A variable at its [place] in the brick. Only in code that is being generated. */
    data class Cell(val place: Int, val isPointer: Boolean, override val range: SourceRange) : Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = false
    }

    /** `a[index]`; [place] is that of the first element once it is known. */
    data class Element(
        val variable: Variable,
        val index: Expression,
        override val range: SourceRange,
        val place: Int = UNKNOWN_PLACE,
    ) : Expression() {
        override val parts get() = listOf(index)
        override val isPromisedConstant get() = false
    }

    /** `&variable`, or `&variable[offset]`; [place] as for [Element]. */
    data class AddressOf(
        val variable: Variable,
        val offset: Int,
        override val range: SourceRange,
        val place: Int = UNKNOWN_PLACE,
    ) : Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = true
    }

    /** `*variable`; [place] is that of the pointer once it is known. */
    data class PointedAt(val variable: Variable, override val range: SourceRange, val place: Int = UNKNOWN_PLACE) :
        Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = false
    }

    data class Unary(val operator: UnaryOperator, val operand: Expression, override val range: SourceRange) :
        Expression() {
        override val parts get() = listOf(operand)
        override val isPromisedConstant get() = operand.isPromisedConstant
    }

    data class Binary(
        val operator: BinaryOperator,
        val left: Expression,
        val right: Expression,
        override val range: SourceRange,
    ) : Expression() {
        override val parts get() = listOf(left, right)
        override val isPromisedConstant get() = left.isPromisedConstant && right.isPromisedConstant
    }

    data class Choice(
        val condition: Expression,
        val then: Expression,
        val otherwise: Expression,
        override val range: SourceRange,
    ) : Expression() {
        override val parts get() = listOf(condition, then, otherwise)
        override val isPromisedConstant get() = parts.all { it.isPromisedConstant }
    }

    /** `++v`, `v++`, `--v` or `v--`; [target] is a variable or a cell. */
    data class Step(
        val target: Expression,
        val isIncrement: Boolean,
        val isPrefix: Boolean,
        override val range: SourceRange,
    ) : Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = false
    }

    /** `@source`: 65536 times the number of the source plus the argument; that of the source of constants is one. */
    data class Source(val source: Expression, override val range: SourceRange) : Expression() {
        override val parts get() = listOf(source)
        override val isPromisedConstant get() = source.constant == null || constant != null
    }

    /** `@@(sources)[index]`. */
    data class IndexedSource(val sources: Expression, val index: Expression, override val range: SourceRange) :
        Expression() {
        override val parts get() = listOf(sources, index)
        override val isPromisedConstant get() = false
    }

    /** `__sensor(sensor)`, `__type(x)` or `__event_src(x)`. */
    data class Query(val kind: QueryKind, val operand: Expression, override val range: SourceRange) : Expression() {
        override val parts get() = listOf(operand)
        override val isPromisedConstant get() = true
    }

    /** `__taskid`; [task] once it is known. */
    data class TaskNumber(override val range: SourceRange, val task: Int? = null) : Expression() {
        override val parts get() = emptyList<Expression>()
        override val isPromisedConstant get() = true
    }

    companion object {
        const val UNKNOWN_PLACE = -1

        /** The greatest weight; no program with such an expression fits into a brick. */
        const val HEAVY = 20_000
    }
}

internal enum class UnaryOperator(val sign: String) {
    /** `0 - x`. */
    MINUS("-"),

    /** `-1 - x` unless constant. */
    COMPLEMENT("~"),
    NOT("!"),
    ABSOLUTE("abs"),
    SIGN("sign"),
}

internal enum class QueryKind { SENSOR, TYPE, EVENT_SOURCE }

/**
 * @property sign as written.
 * @property precedence higher binds tighter.
 */
internal enum class BinaryOperator(val sign: String, val precedence: Int, val kind: OperatorKind) {
    OR_ELSE("||", 1, OperatorKind.LOGICAL),
    AND_THEN("&&", 2, OperatorKind.LOGICAL),
    OR("|", 3, OperatorKind.ARITHMETIC),
    EXCLUSIVE_OR("^", 4, OperatorKind.REWRITTEN),
    AND("&", 5, OperatorKind.ARITHMETIC),
    EQUAL("==", 6, OperatorKind.COMPARISON),
    NOT_EQUAL("!=", 6, OperatorKind.COMPARISON),
    LESS("<", 7, OperatorKind.COMPARISON),
    GREATER(">", 7, OperatorKind.COMPARISON),
    AT_MOST("<=", 7, OperatorKind.COMPARISON),
    AT_LEAST(">=", 7, OperatorKind.COMPARISON),
    SHIFT_LEFT("<<", 8, OperatorKind.REWRITTEN),
    SHIFT_RIGHT(">>", 8, OperatorKind.REWRITTEN),
    PLUS("+", 9, OperatorKind.ARITHMETIC),
    MINUS("-", 9, OperatorKind.ARITHMETIC),
    TIMES("*", 10, OperatorKind.ARITHMETIC),
    DIVIDED_BY("/", 10, OperatorKind.ARITHMETIC),
    MODULO("%", 10, OperatorKind.REWRITTEN),
    ;

    companion object {
        private val bySign = entries.associateBy { it.sign }

        fun of(sign: String): BinaryOperator? = bySign[sign]
    }
}

internal enum class OperatorKind {
    /** One instruction on a variable. */
    ARITHMETIC,

    /** Several instructions, unless constant. */
    REWRITTEN,
    COMPARISON,
    LOGICAL,
}
