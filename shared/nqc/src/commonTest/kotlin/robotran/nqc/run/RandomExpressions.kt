package robotran.nqc.run

import kotlin.random.Random

/**
 * An expression as text, and its value on a brick.
 *
 * @property isConstant whether the compiler computes it, with more bits than a brick.
 */
internal class TestExpression(val text: String, val value: Int, val isConstant: Boolean = false)

/** Makes expressions of the [variables], without constants that the compiler would compute with 32 bits. */
internal class RandomExpressions(private val random: Random, private val variables: Map<String, Int>) {
    fun next(depth: Int): TestExpression = if (depth == 0 || random.nextInt(5) == 0) {
        variable()
    } else {
        when (random.nextInt(12)) {
            0 -> unary("-", next(depth - 1)) { -it }
            1 -> unary("~", next(depth - 1)) { it.inv() }
            2 -> call("abs", next(depth - 1)) { if (it == LOWEST) -LOWEST - 1 else kotlin.math.abs(it) }
            3 -> call("sign", next(depth - 1)) { it.compareTo(0) }
            4 -> unary("!", next(depth - 1)) { if (it == 0) 1 else 0 }
            5 -> choice(depth)
            6 -> shift(depth)
            7 -> division(depth)
            else -> binary(depth)
        }
    }

    private fun variable() = variables.entries.random(random).let { TestExpression(it.key, it.value) }

    private fun constant() = random.nextInt(-100, 100).let { TestExpression("$it", it, isConstant = true) }

    private fun operand(depth: Int) = if (random.nextInt(3) == 0) constant() else next(depth - 1)

    private fun unary(sign: String, operand: TestExpression, compute: (Int) -> Int) =
        TestExpression("$sign(${operand.text})", cut(compute(operand.value)))

    private fun call(name: String, operand: TestExpression, compute: (Int) -> Int) =
        TestExpression("$name(${operand.text})", cut(compute(operand.value)))

    private fun choice(depth: Int): TestExpression {
        val (condition, then, otherwise) = List(3) { next(depth - 1) }
        val value = if (condition.value != 0) then.value else otherwise.value
        return TestExpression("((${condition.text}) ? (${then.text}) : (${otherwise.text}))", value)
    }

    private fun shift(depth: Int): TestExpression {
        val operand = next(depth - 1)
        val count = random.nextInt(17)
        val isLeft = random.nextBoolean()
        val bits = operand.value and 0xFFFF
        val shifted = if (count > 15) {
            0
        } else if (isLeft) {
            bits shl count
        } else {
            bits shr count
        }
        return TestExpression("(${operand.text}) ${if (isLeft) "<<" else ">>"} $count".let { "($it)" }, cut(shifted))
    }

    private fun division(depth: Int): TestExpression {
        val dividend = next(depth - 1)
        val divisor = (random.nextInt(2, 50)) * (if (random.nextBoolean()) 1 else -1)
        val isModulo = random.nextBoolean()
        val value = if (isModulo) dividend.value % divisor else dividend.value / divisor
        return TestExpression("((${dividend.text}) ${if (isModulo) "%" else "/"} ($divisor))", cut(value))
    }

    private fun binary(depth: Int): TestExpression {
        val left = next(depth - 1)
        val right = operand(depth)
        val isMirrored = right.isConstant && random.nextBoolean()
        val (first, second) = if (isMirrored) right to left else left to right
        val (sign, compute) = OPERATORS.entries.random(random)
        return TestExpression("((${first.text}) $sign (${second.text}))", cut(compute(first.value, second.value)))
    }

    companion object {
        private const val LOWEST = -32768

        /** The 16 bits that a brick keeps. */
        fun cut(value: Int): Int = value.toShort().toInt()

        private val OPERATORS: Map<String, (Int, Int) -> Int> = mapOf(
            "+" to { a, b -> a + b },
            "-" to { a, b -> a - b },
            "*" to { a, b -> a * b },
            "&" to { a, b -> a and b },
            "|" to { a, b -> a or b },
            "^" to { a, b -> a xor b },
            "==" to { a, b -> if (a == b) 1 else 0 },
            "!=" to { a, b -> if (a != b) 1 else 0 },
            "<" to { a, b -> if (a < b) 1 else 0 },
            ">" to { a, b -> if (a > b) 1 else 0 },
            "<=" to { a, b -> if (a <= b) 1 else 0 },
            ">=" to { a, b -> if (a >= b) 1 else 0 },
            "&&" to { a, b -> if (a != 0 && b != 0) 1 else 0 },
            "||" to { a, b -> if (a != 0 || b != 0) 1 else 0 },
        )
    }
}
