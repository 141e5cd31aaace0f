package robotran.nqc.generate

import robotran.legofirmware.instructions.Relation
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.tree.BinaryOperator
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Unary
import robotran.nqc.tree.OperatorKind
import robotran.nqc.tree.Place
import robotran.nqc.tree.UnaryOperator

/** Generates jumps that depend on conditions. */
internal class ConditionEmitter(private val emitter: Emitter, private val values: ValueEmitter) {
    /** Continues at [label] if [expression] is true, or false if [isWanted] is false; else goes on. */
    fun branch(expression: Expression, label: Label, isWanted: Boolean) {
        emitter.work(1)
        val constant = expression.constant
        when {
            constant != null -> if ((constant != 0) == isWanted) emitter.jump(label)

            expression is Unary && expression.operator == UnaryOperator.NOT -> {
                branch(expression.operand, label, !isWanted)
            }

            expression is Binary && expression.operator.kind == OperatorKind.LOGICAL -> {
                logical(expression, label, isWanted)
            }

            expression is Binary && expression.operator.kind == OperatorKind.COMPARISON -> {
                comparison(expression, label, isWanted)
            }

            else -> truth(expression, label, isWanted)
        }
    }

    private fun truth(expression: Expression, label: Label, isWanted: Boolean) {
        val place = values.constrained(expression, allowed = ::isTestable)
        val relation = if (isWanted) Relation.NOT_EQUAL else Relation.EQUAL
        emitter.test(Emitter.constant(0), relation, place, label)
        emitter.release(place)
    }

    private fun logical(expression: Binary, label: Label, isWanted: Boolean) {
        val eitherDecides = (expression.operator == BinaryOperator.OR_ELSE) == isWanted
        if (eitherDecides) {
            branch(expression.left, label, isWanted)
            branch(expression.right, label, isWanted)
        } else {
            val out = emitter.buffer.label()
            branch(expression.left, out, !isWanted)
            branch(expression.right, label, isWanted)
            emitter.buffer.place(out)
        }
    }

    private fun comparison(expression: Binary, label: Label, isWanted: Boolean) {
        var left = values.constrained(expression.left, allowed = ::isTestable)
        var right = values.constrained(expression.right, allowed = ::isTestable)
        var operator = expression.operator
        if (right.isConstant) {
            left = right.also { right = left }
            operator = MIRRORED[operator] ?: operator
        }
        if (!isWanted) operator = OPPOSITES.getValue(operator)
        val relation = RELATIONS[operator]
        when {
            relation != null -> emitter.test(left, relation, right, label)
            left.isConstant -> strict(left, operator, right, label)

            else -> {
                val around = emitter.buffer.label()
                emitter.test(left, RELATIONS.getValue(OPPOSITES.getValue(operator)), right, around)
                emitter.jump(label)
                emitter.buffer.place(around)
            }
        }
        emitter.release(left)
        emitter.release(right)
    }

    /** Tests whether the constant [left] is less or greater, which the brick can only tell for the next number. */
    private fun strict(left: Place, operator: BinaryOperator, right: Place, label: Label) {
        val number = left.data.toShort().toInt()
        if (operator == BinaryOperator.GREATER) {
            if (number == Short.MIN_VALUE.toInt()) return
            emitter.test(Emitter.constant(number - 1), Relation.AT_LEAST, right, label)
        } else {
            if (number == Short.MAX_VALUE.toInt()) return
            emitter.test(Emitter.constant(number + 1), Relation.AT_MOST, right, label)
        }
    }

    private companion object {
        /** Sources that tests do not take: a random number, the program, and one of another brick. */
        val NOT_TESTABLE = setOf(ValueSource.RANDOM.code, ValueSource.PROGRAM.code, 16)

        fun isTestable(type: Int) = type !in NOT_TESTABLE

        val RELATIONS = mapOf(
            BinaryOperator.AT_MOST to Relation.AT_MOST,
            BinaryOperator.AT_LEAST to Relation.AT_LEAST,
            BinaryOperator.NOT_EQUAL to Relation.NOT_EQUAL,
            BinaryOperator.EQUAL to Relation.EQUAL,
        )

        /** The operators for the operands the other way round, where they differ. */
        val MIRRORED = mapOf(
            BinaryOperator.AT_MOST to BinaryOperator.AT_LEAST,
            BinaryOperator.AT_LEAST to BinaryOperator.AT_MOST,
            BinaryOperator.LESS to BinaryOperator.GREATER,
            BinaryOperator.GREATER to BinaryOperator.LESS,
        )

        val OPPOSITES = mapOf(
            BinaryOperator.AT_MOST to BinaryOperator.GREATER,
            BinaryOperator.AT_LEAST to BinaryOperator.LESS,
            BinaryOperator.NOT_EQUAL to BinaryOperator.EQUAL,
            BinaryOperator.EQUAL to BinaryOperator.NOT_EQUAL,
            BinaryOperator.LESS to BinaryOperator.AT_LEAST,
            BinaryOperator.GREATER to BinaryOperator.AT_MOST,
        )
    }
}
