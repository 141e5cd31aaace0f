package robotran.nqc.run

import kotlin.random.Random

/** The values of variables by name. */
internal typealias Values = Map<String, Int>

/**
 * An expression as text, and how a brick computes it.
 *
 * @property isConstant whether the compiler computes it, with more bits than a brick.
 */
internal class TestExpression(
    val text: String,
    val isConstant: Boolean = false,
    private val compute: (Values) -> Int,
) {
    /** Its value in the 16 bits of a brick. */
    fun valueIn(values: Values): Int = compute(values).toShort().toInt()
}

/** Makes expressions of the [variables], without constants that the compiler would compute with 32 bits. */
internal class RandomExpressions(private val random: Random, private val variables: List<String>) {
    /** @param depth max operators inside of each other. */
    fun next(depth: Int): TestExpression = if (depth == 0 || random.nextInt(5) == 0) {
        variable()
    } else {
        when (random.nextInt(12)) {
            0 -> unary("-", depth) { -it }
            1 -> unary("~", depth) { it.inv() }
            2 -> unary("abs", depth) { if (it == LOWEST) -(LOWEST + 1) else kotlin.math.abs(it) }
            3 -> unary("sign", depth) { it.compareTo(0) }
            4 -> unary("!", depth) { if (it == 0) 1 else 0 }
            5 -> choice(depth)
            6 -> shift(depth)
            7 -> division(depth)
            else -> binary(depth)
        }
    }

    private fun variable(): TestExpression {
        val name = variables.random(random)
        return TestExpression(name) { it.getValue(name) }
    }

    private fun constant(): TestExpression {
        val number = random.nextInt(-100, 100)
        return TestExpression("$number", isConstant = true) { number }
    }

    private fun unary(sign: String, depth: Int, compute: (Int) -> Int): TestExpression {
        val operand = next(depth - 1)
        return TestExpression("$sign(${operand.text})") { compute(operand.valueIn(it)) }
    }

    private fun choice(depth: Int): TestExpression {
        val (condition, then, otherwise) = List(3) { next(depth - 1) }
        return TestExpression("((${condition.text}) ? (${then.text}) : (${otherwise.text}))") {
            if (condition.valueIn(it) != 0) then.valueIn(it) else otherwise.valueIn(it)
        }
    }

    private fun shift(depth: Int): TestExpression {
        val operand = next(depth - 1)
        val count = random.nextInt(17)
        val isLeft = random.nextBoolean()
        return TestExpression("((${operand.text}) ${if (isLeft) "<<" else ">>"} $count)") {
            val bits = operand.valueIn(it) and 0xFFFF
            if (count > 15) {
                0
            } else if (isLeft) {
                bits shl count
            } else {
                bits shr count
            }
        }
    }

    private fun division(depth: Int): TestExpression {
        val dividend = next(depth - 1)
        val divisor = random.nextInt(2, 50) * (if (random.nextBoolean()) 1 else -1)
        val isModulo = random.nextBoolean()
        return TestExpression("((${dividend.text}) ${if (isModulo) "%" else "/"} ($divisor))") {
            if (isModulo) dividend.valueIn(it) % divisor else dividend.valueIn(it) / divisor
        }
    }

    private fun binary(depth: Int): TestExpression {
        val left = next(depth - 1)
        val right = if (random.nextInt(3) == 0) constant() else next(depth - 1)
        val (first, second) = if (right.isConstant && random.nextBoolean()) right to left else left to right
        val (sign, compute) = OPERATORS.entries.random(random)
        return TestExpression("((${first.text}) $sign (${second.text}))") {
            compute(first.valueIn(it), second.valueIn(it))
        }
    }

    private companion object {
        const val LOWEST = -32768

        val OPERATORS: Map<String, (Int, Int) -> Int> = mapOf(
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
