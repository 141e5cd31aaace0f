package robotran.nqc.tree

import robotran.nqc.tree.Expression.AddressOf
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Choice
import robotran.nqc.tree.Expression.Constant
import robotran.nqc.tree.Expression.Query
import robotran.nqc.tree.Expression.Source
import robotran.nqc.tree.Expression.TaskNumber
import robotran.nqc.tree.Expression.Unary

/** Computes [Expression.constant]. */
internal fun fold(expression: Expression): Int? = when (expression) {
    is Constant -> expression.value
    is AddressOf -> expression.place.takeIf { it >= 0 }?.plus(expression.offset)
    is Unary -> expression.operand.constant?.let { foldUnary(expression.operator, it) }
    is Binary -> foldBinary(expression)
    is Choice -> expression.condition.constant?.let { branchOf(expression, it != 0).constant }
    is Query -> foldQuery(expression)
    is TaskNumber -> expression.task
    is Source -> expression.source.constant?.let(::placeOfSource)?.takeIf { it.isConstant }?.data?.toShort()?.toInt()
    else -> null
}

/** The side of [choice] that is taken. */
private fun branchOf(choice: Choice, isTrue: Boolean): Expression = if (isTrue) choice.then else choice.otherwise

internal val Binary.isDivision: Boolean
    get() = operator == BinaryOperator.DIVIDED_BY || operator == BinaryOperator.MODULO

private fun foldUnary(operator: UnaryOperator, value: Int): Int = when (operator) {
    UnaryOperator.MINUS -> -value
    UnaryOperator.COMPLEMENT -> value.inv()
    UnaryOperator.NOT -> truth(value == 0)
    UnaryOperator.ABSOLUTE -> if (value < 0) -value else value
    UnaryOperator.SIGN -> value.compareTo(0)
}

private fun foldBinary(expression: Binary): Int? {
    val left = expression.left.constant
    val right = expression.right.constant
    if (expression.operator.kind == OperatorKind.LOGICAL) {
        // One side can decide, whatever the other does.
        val decisive = expression.operator == BinaryOperator.OR_ELSE
        if (left?.let { (it != 0) == decisive } == true || right?.let { (it != 0) == decisive } == true) {
            return truth(decisive)
        }
        return if (left != null && right != null) truth(!decisive) else null
    }
    return if (left == null || right == null) null else compute(expression.operator, left, right)
}

private fun compute(operator: BinaryOperator, left: Int, right: Int): Int? = when (operator) {
    BinaryOperator.OR -> left or right
    BinaryOperator.EXCLUSIVE_OR -> left xor right
    BinaryOperator.AND -> left and right
    BinaryOperator.EQUAL -> truth(left == right)
    BinaryOperator.NOT_EQUAL -> truth(left != right)
    BinaryOperator.LESS -> truth(left < right)
    BinaryOperator.GREATER -> truth(left > right)
    BinaryOperator.AT_MOST -> truth(left <= right)
    BinaryOperator.AT_LEAST -> truth(left >= right)
    BinaryOperator.SHIFT_LEFT -> left shl right
    BinaryOperator.SHIFT_RIGHT -> left shr right
    BinaryOperator.PLUS -> left + right
    BinaryOperator.MINUS -> left - right
    BinaryOperator.TIMES -> left * right
    BinaryOperator.DIVIDED_BY -> if (right == 0) null else left / right
    BinaryOperator.MODULO -> if (right == 0) null else left % right
    BinaryOperator.OR_ELSE, BinaryOperator.AND_THEN -> null
}

private fun foldQuery(expression: Query): Int? = when (expression.kind) {
    QueryKind.SENSOR -> sensorOf(expression.operand)
    QueryKind.TYPE -> if (expression.operand.constant != null) CONSTANT_SOURCE else 0
    QueryKind.EVENT_SOURCE -> sourceOf(expression.operand)?.let { eventSourceOf(it) }
}

internal fun truth(isTrue: Boolean): Int = if (isTrue) 1 else 0

/** The number of the source of constants, which is also what `__type` of a constant gives. */
private const val CONSTANT_SOURCE = 2
