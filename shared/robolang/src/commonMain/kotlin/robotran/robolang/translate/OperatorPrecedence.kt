package robotran.robolang.translate

import robotran.robolang.syntax.BinaryOperator

/** The precedence of Java's operators; higher binds tighter. */
internal object OperatorPrecedence {
    const val UNARY = 8
    const val PRIMARY = 9

    fun of(operator: BinaryOperator): Int = when (operator) {
        BinaryOperator.OR -> 1
        BinaryOperator.AND -> 2
        BinaryOperator.EQUAL, BinaryOperator.NOT_EQUAL -> 3
        BinaryOperator.LESS, BinaryOperator.LESS_OR_EQUAL, BinaryOperator.GREATER, BinaryOperator.GREATER_OR_EQUAL -> 4
        BinaryOperator.PLUS, BinaryOperator.MINUS -> 5
        BinaryOperator.TIMES, BinaryOperator.DIVIDE, BinaryOperator.MOD -> 6
    }

    fun textOf(operator: BinaryOperator): String = when (operator) {
        BinaryOperator.OR -> "||"
        BinaryOperator.AND -> "&&"
        BinaryOperator.MOD -> "%"
        else -> operator.text
    }
}
