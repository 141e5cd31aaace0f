package robotran.robolang.run

import robotran.robolang.syntax.BinaryOperator

/** The instruction that pops two operands and pushes the result. */
internal fun operation(operator: BinaryOperator, arithmetic: Arithmetic): StackInstruction = when (operator) {
    BinaryOperator.EQUAL -> comparison { left, right -> arithmetic.isEqual(left, right) }
    BinaryOperator.NOT_EQUAL -> comparison { left, right -> !arithmetic.isEqual(left, right) }
    BinaryOperator.LESS -> comparison { left, right -> arithmetic.isLess(left, right) }

    BinaryOperator.LESS_OR_EQUAL -> comparison { left, right ->
        arithmetic.isLess(left, right) ||
            arithmetic.isEqual(left, right)
    }

    BinaryOperator.GREATER -> comparison { left, right -> arithmetic.isLess(right, left) }

    BinaryOperator.GREATER_OR_EQUAL -> comparison { left, right ->
        arithmetic.isLess(right, left) ||
            arithmetic.isEqual(left, right)
    }

    BinaryOperator.PLUS -> calculation { machine, left, right -> arithmetic.plus(left, right, machine.messages) }
    BinaryOperator.MINUS -> calculation { machine, left, right -> arithmetic.minus(left, right, machine.messages) }
    BinaryOperator.TIMES -> calculation { machine, left, right -> arithmetic.times(left, right, machine.messages) }
    BinaryOperator.DIVIDE -> calculation { machine, left, right -> arithmetic.divide(left, right, machine.messages) }
    BinaryOperator.MOD -> calculation { machine, left, right -> arithmetic.modulo(left, right, machine.messages) }
    BinaryOperator.AND, BinaryOperator.OR -> error("These decide before both operands are known.")
}

private inline fun calculation(crossinline calculate: (InterpreterState, Int, Int) -> Int) = StackInstruction {
    val right = it.pop()
    val left = it.pop()
    it.push(calculate(it.machine, left, right))
}

private inline fun comparison(crossinline compare: (Int, Int) -> Boolean) = StackInstruction {
    val right = it.pop()
    val left = it.pop()
    it.pushTruth(compare(left, right))
}
