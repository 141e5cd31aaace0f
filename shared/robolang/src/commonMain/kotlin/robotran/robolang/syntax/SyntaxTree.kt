package robotran.robolang.syntax

import robotran.robolang.SourceRange

/**
 * A program as the parser understood it.
 *
 * @property statements the main program.
 * @property comments all comments in their order, `//` included; no statement needs them, a formatter does.
 */
internal data class SyntaxTree(
    val statements: List<Statement>,
    val comments: List<Token>,
)

/** Something to do. A block's [range] is that of its first line. */
internal sealed interface Statement {
    val range: SourceRange

    /** `forward D` and `backward D`, in centimetres. */
    data class Move(override val range: SourceRange, val direction: MoveDirection, val distance: Expression) : Statement

    /** `turn left A` and `turn right A`, in degrees. */
    data class Turn(override val range: SourceRange, val direction: TurnDirection, val angle: Expression) : Statement

    /** `pen down` and `pen up`. */
    data class Pen(override val range: SourceRange, val position: PenPosition) : Statement

    /** `wait T seconds` and `wait T milliseconds`. */
    data class Wait(override val range: SourceRange, val duration: Expression, val unit: TimeUnit) : Statement

    /** `beep`. */
    data class Beep(override val range: SourceRange) : Statement

    /** `show N`. */
    data class Show(override val range: SourceRange, val value: Expression) : Statement

    /** `repeat N times` .. `end`. */
    data class Repeat(override val range: SourceRange, val count: Expression, val body: List<Statement>) : Statement
}

/** Something that has a value. */
internal sealed interface Expression {
    val range: SourceRange

    /** A number as it is written, with its sign. */
    data class Number(override val range: SourceRange, val text: String, val value: NumberValue) : Expression
}

/** Numbers are whole or decimal, as `int` and `float` are in Java. */
internal sealed interface NumberValue {
    /** The nearest 32-bit decimal number. */
    val decimal: Float

    val isNegative: Boolean

    data class Whole(val value: Int) : NumberValue {
        override val decimal: Float get() = value.toFloat()
        override val isNegative: Boolean get() = value < 0
    }

    data class Decimal(override val decimal: Float) : NumberValue {
        override val isNegative: Boolean get() = decimal < 0f
    }
}

internal enum class MoveDirection { FORWARD, BACKWARD }

internal enum class TurnDirection { LEFT, RIGHT }

internal enum class PenPosition { DOWN, UP }

internal enum class TimeUnit { SECONDS, MILLISECONDS }
