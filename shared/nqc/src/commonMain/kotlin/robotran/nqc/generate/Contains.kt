package robotran.nqc.generate

import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.AddressOf
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.Expression.Element
import robotran.nqc.tree.Expression.PointedAt
import robotran.nqc.tree.Expression.Step

/** Whether [expression] uses the variable [place], so that it must be computed before the variable changes. */
internal fun contains(expression: Expression, place: Int): Boolean = when (expression) {
    is Cell -> expression.place == place
    is PointedAt -> expression.place == place
    is AddressOf -> expression.place == place
    is Step -> contains(expression.target, place)
    is Element -> expression.index.constant?.let { expression.place + it == place } ?: contains(expression.index, place)
    else -> expression.parts.any { contains(it, place) }
}
