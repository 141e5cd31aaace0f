package robotran.robolang.run

import robotran.robolang.check.ValueType
import robotran.robolang.messages.RobolangRunMessages

/** The arithmetic of one number type, on the 32 bits on the stack, with Java's semantics. */
internal sealed interface Arithmetic {
    fun plus(left: Int, right: Int, messages: RobolangRunMessages): Int

    fun minus(left: Int, right: Int, messages: RobolangRunMessages): Int

    fun times(left: Int, right: Int, messages: RobolangRunMessages): Int

    fun divide(left: Int, right: Int, messages: RobolangRunMessages): Int

    fun modulo(left: Int, right: Int, messages: RobolangRunMessages): Int

    fun negate(value: Int, messages: RobolangRunMessages): Int

    fun isLess(left: Int, right: Int): Boolean

    fun isEqual(left: Int, right: Int): Boolean

    /** -1, 0 or 1. */
    fun sign(value: Int): Int

    fun text(value: Int): String

    /** `int`: 32 bits with overflow; division truncates. */
    data object Whole : Arithmetic {
        override fun plus(left: Int, right: Int, messages: RobolangRunMessages) = left + right

        override fun minus(left: Int, right: Int, messages: RobolangRunMessages) = left - right

        override fun times(left: Int, right: Int, messages: RobolangRunMessages) = left * right

        /** Division by -1 is a negation: the smallest number has no opposite, and some processors trap. */
        override fun divide(left: Int, right: Int, messages: RobolangRunMessages): Int = when (right) {
            0 -> fail(messages.divisionByZero(text(left)))
            -1 -> -left
            else -> left / right
        }

        override fun modulo(left: Int, right: Int, messages: RobolangRunMessages): Int = when (right) {
            0 -> fail(messages.divisionByZero(text(left)))
            -1 -> 0
            else -> left % right
        }

        override fun negate(value: Int, messages: RobolangRunMessages) = -value

        override fun isLess(left: Int, right: Int) = left < right

        override fun isEqual(left: Int, right: Int) = left == right

        override fun sign(value: Int) = value.compareTo(0).coerceIn(-1, 1)

        override fun text(value: Int) = value.toString()
    }

    /** `float`: division by zero gives an infinite number, as on the brick. */
    data object Decimal : Arithmetic {
        override fun plus(left: Int, right: Int, messages: RobolangRunMessages) = bits(decimal(left) + decimal(right))

        override fun minus(left: Int, right: Int, messages: RobolangRunMessages) = bits(decimal(left) - decimal(right))

        override fun times(left: Int, right: Int, messages: RobolangRunMessages) = bits(decimal(left) * decimal(right))

        override fun divide(left: Int, right: Int, messages: RobolangRunMessages) = bits(decimal(left) / decimal(right))

        /** The remainder by repeated subtraction; the brick has no such operation. */
        override fun modulo(left: Int, right: Int, messages: RobolangRunMessages): Int {
            val dividend = decimal(left)
            val divisor = decimal(right)
            return bits(dividend - divisor * (dividend / divisor).toInt())
        }

        override fun negate(value: Int, messages: RobolangRunMessages) = bits(-decimal(value))

        override fun isLess(left: Int, right: Int) = decimal(left) < decimal(right)

        override fun isEqual(left: Int, right: Int) = decimal(left) == decimal(right)

        override fun sign(value: Int) = decimal(value).let {
            if (it < 0f) {
                -1
            } else if (it > 0f) {
                1
            } else {
                0
            }
        }

        override fun text(value: Int) = decimalText(decimal(value))

        private fun decimal(bits: Int) = Float.fromBits(bits)

        private fun bits(value: Float) = value.toRawBits()
    }

    companion object {
        /** @param isShort whether whole numbers have 31 bits and division by 0 is always a mistake. */
        fun of(type: ValueType, isShort: Boolean): Arithmetic = when {
            type == ValueType.DECIMAL -> if (isShort) HubDecimal else Decimal
            else -> if (isShort) HubWhole else Whole
        }
    }
}
