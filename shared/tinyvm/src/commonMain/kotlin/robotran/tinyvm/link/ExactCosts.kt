package robotran.tinyvm.link

import robotran.tinyvm.config.NxtCosts

/** What operations take beyond one bytecode. */
internal object ExactCosts {
    fun of(operation: Int): Int = when (operation) {
        Operation.DIVIDE_LONG, Operation.REMAINDER_LONG -> NxtCosts.WHOLE_64_DIVISION
        Operation.ADD_DOUBLE_64, Operation.SUBTRACT_DOUBLE_64, Operation.MULTIPLY_DOUBLE_64 -> NxtCosts.DECIMAL_64
        Operation.DIVIDE_DOUBLE_64, Operation.REMAINDER_DOUBLE_64 -> NxtCosts.DECIMAL_64_DIVISION
        else -> 0
    }
}
