package robotran.nqc.generate

import robotran.legofirmware.instructions.Relation
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.tree.BinaryOperator
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Constant
import robotran.nqc.tree.Place
import robotran.nqc.tree.VariableOperation

/** Generates the code of operators with two operands, as far as they compute numbers. */
internal class CombinationEmitter(private val emitter: Emitter, private val values: ValueEmitter) {
    /** Computes an operation that the brick has an instruction for. */
    fun any(expression: Binary): Place {
        val left = values.any(expression.left)
        val target = if (emitter.isTemporary(left)) {
            left.data
        } else {
            emitter.temporary(expression.range).also { emitter.move(it, left) }
        }
        if (emitter.releasesAll && left.usesTemporary) emitter.release(left)
        combine(expression, target)
        return Emitter.variable(target)
    }

    fun to(expression: Binary, target: Int) {
        if (contains(expression.right, target)) return values.throughAny(expression, target)
        values.to(expression.left, target)
        combine(expression, target)
    }

    private fun combine(expression: Binary, target: Int) {
        val right = values.operand(expression.right)
        emitter.operation(OPERATIONS.getValue(expression.operator), target, right)
        emitter.release(right)
    }

    /** Computes an operation that the brick has no instruction for. */
    fun anyRewritten(expression: Binary): Place {
        if (expression.operator == BinaryOperator.EXCLUSIVE_OR) return any(withoutExclusiveOr(expression))
        val target = emitter.temporary(expression.range)
        compute(expression, target)
        return Emitter.variable(target)
    }

    fun toRewritten(expression: Binary, target: Int) = when (expression.operator) {
        BinaryOperator.EXCLUSIVE_OR -> to(withoutExclusiveOr(expression), target)

        BinaryOperator.MODULO -> if (contains(expression, target)) {
            values.throughAny(expression, target)
        } else {
            modulo(expression, target)
        }

        else -> shift(expression, target)
    }

    private fun compute(expression: Binary, target: Int) =
        if (expression.operator == BinaryOperator.MODULO) modulo(expression, target) else shift(expression, target)

    /** `(-1 - (a & b)) & (a | b)`. */
    private fun withoutExclusiveOr(expression: Binary): Binary = with(expression) {
        val both = Binary(BinaryOperator.AND, left, right, range)
        val notBoth = Binary(BinaryOperator.MINUS, Constant(-1, range), both, range)
        Binary(BinaryOperator.AND, notBoth, Binary(BinaryOperator.OR, left, right, range), range)
    }

    /** `-(a / b * b - a)`. */
    private fun modulo(expression: Binary, target: Int) {
        val left = values.constrained(expression.left) { it in STABLE }
        val right = values.constrained(expression.right) { it in STABLE }
        emitter.move(target, left)
        emitter.operation(VariableOperation.DIVIDE, target, right)
        emitter.operation(VariableOperation.MULTIPLY, target, right)
        emitter.operation(VariableOperation.SUBTRACT, target, left)
        emitter.operation(VariableOperation.MULTIPLY, target, Emitter.constant(-1))
        emitter.release(left)
        emitter.release(right)
    }

    private fun shift(expression: Binary, target: Int) {
        // A count that is not constant is a mistake that the parser has reported.
        val count = maxOf(0, expression.right.constant ?: 0)
        if (count >= Short.SIZE_BITS) return emitter.move(target, Emitter.constant(0))
        val factor = Emitter.constant(1 shl count)
        values.to(expression.left, target)
        if (expression.operator == BinaryOperator.SHIFT_LEFT) {
            emitter.operation(VariableOperation.MULTIPLY, target, factor)
        } else {
            shiftRight(target, factor, count)
        }
    }

    /** Shifts a negative number without its sign, and puts that back. */
    private fun shiftRight(target: Int, factor: Place, count: Int) {
        val isPositive = emitter.buffer.label()
        emitter.test(Emitter.constant(0), Relation.AT_MOST, Emitter.variable(target), isPositive)
        emitter.operation(VariableOperation.AND, target, Emitter.constant(Short.MAX_VALUE.toInt()))
        emitter.operation(VariableOperation.DIVIDE, target, factor)
        emitter.operation(VariableOperation.OR, target, Emitter.constant(SIGN_BIT shr count))
        val done = emitter.buffer.label()
        emitter.jump(done)
        emitter.buffer.place(isPositive)
        emitter.operation(VariableOperation.DIVIDE, target, factor)
        emitter.buffer.place(done)
    }

    private companion object {
        const val SIGN_BIT = 0x8000

        /** Sources that give the same value when they are read again. */
        val STABLE = setOf(ValueSource.VARIABLE.code, ValueSource.CONSTANT.code)

        val OPERATIONS = mapOf(
            BinaryOperator.PLUS to VariableOperation.ADD,
            BinaryOperator.MINUS to VariableOperation.SUBTRACT,
            BinaryOperator.TIMES to VariableOperation.MULTIPLY,
            BinaryOperator.DIVIDED_BY to VariableOperation.DIVIDE,
            BinaryOperator.AND to VariableOperation.AND,
            BinaryOperator.OR to VariableOperation.OR,
        )
    }
}
