package robotran.robolang.syntax

import robotran.language.source.SourceRange

/** An expression. No two expressions of a program have the same [range]. */
internal sealed interface Expression {
    val range: SourceRange

    /** A number with its sign: `-5` and `- 5` are one number. */
    data class Number(override val range: SourceRange, val text: String, val value: NumberValue) : Expression

    /** `true` and `false`. */
    data class BooleanLiteral(override val range: SourceRange, val value: Boolean) : Expression

    /** `red` and the other colours. */
    data class ColourLiteral(override val range: SourceRange, val colour: PaintColour) : Expression

    /** `[1, 2, 3]`. */
    data class ListOf(override val range: SourceRange, val elements: List<Expression>) : Expression

    /** A constant, a variable or a parameter. */
    data class Variable(override val range: SourceRange, val name: Name) : Expression

    /** `list[i]`, counted from 0. */
    data class ListElement(override val range: SourceRange, val list: Expression, val index: Expression) : Expression

    /** `-x` and `not x`. */
    data class Unary(override val range: SourceRange, val operator: UnaryOperator, val operand: Expression) : Expression

    /** `x + y` and other binary operations. */
    data class Binary(
        override val range: SourceRange,
        val operator: BinaryOperator,
        val left: Expression,
        val right: Expression,
    ) : Expression

    /** `f(1, 2)`: a call of a declared or built-in function. */
    data class Call(override val range: SourceRange, val name: Name, val arguments: List<Expression>) : Expression

    /** A sensor value. */
    data class Sense(override val range: SourceRange, val sense: robotran.robolang.syntax.Sense) : Expression

    /** `(x)`; part of the tree so that the formatter can write it. */
    data class Brackets(override val range: SourceRange, val inner: Expression) : Expression
}

/** [text] is its spelling in Robolang. */
internal enum class UnaryOperator(val text: String) { MINUS("-"), NOT("not") }

/**
 * The binary operators.
 *
 * @property text its spelling in Robolang.
 * @property strength its precedence; higher binds tighter. Operators of the same precedence are left-associative.
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

/** The precedence of `not`: below comparisons, above `and`. */
internal const val STRENGTH_OF_NOT = 3
