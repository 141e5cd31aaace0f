package robotran.robolang.run

import robotran.robolang.messages.RobolangRunMessages
import robotran.robolang.robot.HubFigures

/** Whole numbers of MicroPython on a hub: 31 bits, and beyond them a mistake; division truncates, as on other bricks. */
internal data object HubWhole : Arithmetic by Arithmetic.Whole {
    override fun plus(left: Int, right: Int, messages: RobolangRunMessages): Int =
        short(left.toLong() + right, messages)

    override fun minus(left: Int, right: Int, messages: RobolangRunMessages): Int =
        short(left.toLong() - right, messages)

    override fun times(left: Int, right: Int, messages: RobolangRunMessages): Int =
        short(left.toLong() * right, messages)

    override fun divide(left: Int, right: Int, messages: RobolangRunMessages): Int =
        short(Arithmetic.Whole.divide(left, right, messages).toLong(), messages)

    override fun negate(value: Int, messages: RobolangRunMessages): Int = short(-value.toLong(), messages)
}

/** Decimal numbers of MicroPython: 32 bits, and nothing is divided by 0. */
internal data object HubDecimal : Arithmetic by Arithmetic.Decimal {
    override fun divide(left: Int, right: Int, messages: RobolangRunMessages): Int {
        refuseZero(left, right, messages)
        return Arithmetic.Decimal.divide(left, right, messages)
    }

    override fun modulo(left: Int, right: Int, messages: RobolangRunMessages): Int {
        refuseZero(left, right, messages)
        return Arithmetic.Decimal.modulo(left, right, messages)
    }

    private fun refuseZero(left: Int, right: Int, messages: RobolangRunMessages) {
        if (Float.fromBits(right) == 0f) fail(messages.divisionByZero(text(left)))
    }
}

/** [value] if 31 bits hold it; otherwise the run fails. */
internal fun short(value: Long, messages: RobolangRunMessages): Int =
    if (value in -LARGEST - 1..LARGEST) value.toInt() else fail(messages.tooLargeForHub())

private const val LARGEST = HubFigures.LARGEST.toLong()
