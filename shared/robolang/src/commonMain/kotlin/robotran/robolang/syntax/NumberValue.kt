package robotran.robolang.syntax

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
