package robotran.robolang.syntax

import robotran.robolang.diagnostic.SourceRange

/** Something that has a value. No two expressions of a program have the same [range]. */
internal sealed interface Expression {
    val range: SourceRange

    /** A number as it is written, its sign close to it: `-5` is one number, also where it is typed as `- 5`. */
    data class Number(override val range: SourceRange, val text: String, val value: NumberValue) : Expression

    /** `true` and `false`. */
    data class BooleanLiteral(override val range: SourceRange, val value: Boolean) : Expression

    /** `[1, 2, 3]`. */
    data class ListOf(override val range: SourceRange, val elements: List<Expression>) : Expression

    /** A constant, a variable or a parameter. */
    data class Variable(override val range: SourceRange, val name: Name) : Expression

    /** `list[i]`, counted from 0. */
    data class ListElement(override val range: SourceRange, val list: Expression, val index: Expression) : Expression

    /** `-x` and `not x`. */
    data class Unary(override val range: SourceRange, val operator: UnaryOperator, val operand: Expression) : Expression

    /** `x + y` and its like. */
    data class Binary(
        override val range: SourceRange,
        val operator: BinaryOperator,
        val left: Expression,
        val right: Expression,
    ) : Expression

    /** `f(1, 2)`: a function of the program or one that is built in. */
    data class Call(override val range: SourceRange, val name: Name, val arguments: List<Expression>) : Expression

    /** What the robot feels just now. */
    data class Sense(override val range: SourceRange, val sense: robotran.robolang.syntax.Sense) : Expression

    /** `(x)`, kept because the pupil wrote it. */
    data class Brackets(override val range: SourceRange, val inner: Expression) : Expression
}

/** [text] is how Robolang spells it. */
internal enum class UnaryOperator(val text: String) { MINUS("-"), NOT("not") }

/**
 * The operators between two operands.
 *
 * @property text how Robolang spells it.
 * @property strength the stronger one takes its operands first; those of one strength go from left to right.
 */
internal enum class BinaryOperator(val text: String, val strength: Int) {
    OR("or", 1),
    AND("and", 2),
    EQUAL("==", 4),
    NOT_EQUAL("!=", 4),
    LESS("<", 4),
    LESS_OR_EQUAL("<=", 4),
    GREATER(">", 4),
    GREATER_OR_EQUAL(">=", 4),
    PLUS("+", 5),
    MINUS("-", 5),
    TIMES("*", 6),
    DIVIDE("/", 6),
    MOD("mod", 6),
    ;

    val isComparison: Boolean get() = strength == EQUAL.strength

    val isArithmetic: Boolean get() = strength > EQUAL.strength
}

/** `not` takes its operand after the comparisons and before `and`. */
internal const val STRENGTH_OF_NOT = 3
