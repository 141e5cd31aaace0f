package robotran.nqc.generate

import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.AddressOf
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.Expression.Element
import robotran.nqc.tree.Expression.PointedAt
import robotran.nqc.tree.Expression.Step

/** Whether [expression] uses the variable [index], so that it must be computed before the variable changes. */
internal fun contains(expression: Expression, index: Int): Boolean = when (expression) {
    is Cell -> expression.place == index
    is PointedAt -> expression.place == index
    is AddressOf -> expression.place == index
    is Step -> contains(expression.target, index)
    is Element -> expression.index.constant?.let { expression.place + it == index } ?: contains(expression.index, index)
    else -> expression.parts.any { contains(it, index) }
}
