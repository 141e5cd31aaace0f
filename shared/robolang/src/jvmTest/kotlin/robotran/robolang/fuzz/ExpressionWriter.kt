package robotran.robolang.fuzz

import kotlin.random.Random

/** Generates random expressions of each type from the variables in [known]. */
class ExpressionWriter(
    private val random: Random,
    private val known: KnownNames,
    private val isForNxt: Boolean = false,
    private val hasBumpers: Boolean = true,
) {
    private val hasColourSensor get() = isForNxt && !hasBumpers

    fun whole(depth: Int = DEEPEST): String {
        if (isForNxt && random.nextInt(6) == 0) {
            return pick("distance", "turned b", "turned A", if (hasBumpers) "sensor 4" else "Loudness")
        }
        val leaf = random.nextInt(5)
        val node = if (depth == 0) leaf else random.nextInt(20)
        return when (node) {
            0 -> random.nextInt(20).toString()
            1 -> "-" + random.nextInt(1, 100_000)
            2 -> "light"
            3 -> "sensor ${random.nextInt(1, if (hasColourSensor) COLOUR_PORT else 4)}"
            4, 5, 6 -> known.oneOf(known.wholes, random) ?: "7"
            7, 8 -> "${whole(depth - 1)} ${pick("+", "-", "*")} ${whole(depth - 1)}"
            9 -> "${whole(depth - 1)} ${pick("/", "mod")} ${divisor(depth - 1)}"
            10 -> "(${whole(depth - 1)})"
            11 -> "-(${whole(depth - 1)})"
            12 -> "random(${whole(depth - 1)}, ${whole(depth - 1)})"
            13 -> "abs(${whole(depth - 1)})"
            14 -> "${pick("min", "MAX")}(${whole(depth - 1)}, ${whole(depth - 1)})"
            15 -> "${pick("round", "floor", "ceil")}(${decimal(depth - 1)})"
            16 -> "length(${list(depth - 1)})"
            17 -> "[1, ${whole(depth - 1)}, 3][${pick("0", "2", "abs(light) mod 3")}]"
            18 -> known.oneOf(known.lists, random)?.let { "$it[abs(${whole(depth - 1)}) mod 3]" } ?: "8"
            else -> known.oneOf(known.functions, random)?.let { "$it(${whole(depth - 1)})" } ?: "9"
        }
    }

    fun decimal(depth: Int = DEEPEST): String = when (if (depth == 0) random.nextInt(4) else random.nextInt(12)) {
        0 -> "${random.nextInt(100)}.${random.nextInt(1000)}"
        1 -> "timer"
        2 -> "battery"
        3 -> known.oneOf(known.decimals, random) ?: "0.5"
        4, 5 -> "${decimal(depth - 1)} ${pick("+", "-", "*", "/", "mod")} (${decimal(depth - 1)})"
        6 -> "${whole(depth - 1)} * ${decimal(0)}"
        7 -> "-(${decimal(depth - 1)})"
        8 -> "${pick("sqrt", "sin", "cos", "tan")}(${number(depth - 1)})"
        9 -> "${pick("atan2", "pow")}(${number(depth - 1)}, ${number(depth - 1)})"
        10 -> "${pick("max", "Min")}(${decimal(depth - 1)}, ${whole(depth - 1)})"
        else -> "(${decimal(depth - 1)})"
    }

    fun truth(depth: Int = DEEPEST): String = if (isForNxt && random.nextInt(3) == 0) {
        if (hasBumpers) {
            "button ${pick(
                "enter",
                "left",
                "right",
                "escape",
            )}"
        } else {
            "${colour()} ${pick("==", "!=")} ${colour()}"
        }
    } else {
        usualTruth(depth)
    }

    /** A colour, where there is a colour sensor. */
    fun colour(): String =
        pick("colour", "Color", "sensor $COLOUR_PORT", "red", "black", "white", "blue", "green", "yellow")

    private fun usualTruth(depth: Int): String = when (if (depth == 0) random.nextInt(5) else random.nextInt(12)) {
        0 -> pick("true", "FALSE")
        1 -> if (hasBumpers) "left bumper" else "true"
        2 -> if (hasBumpers) "Right  bumper" else "false"
        3 -> "button ${pick("run", "view", "prgm")}"
        4 -> known.oneOf(known.truths, random) ?: "false"
        5, 6 -> "${number(depth - 1)} ${pick("==", "!=", "<", "<=", ">", ">=")} ${number(depth - 1)}"
        7 -> "not ${truth(0)}"
        8 -> "(${truth(depth - 1)})"
        9 -> "(${truth(depth - 1)}) ${pick("==", "!=")} (${truth(depth - 1)})"
        10 -> "${truth(depth - 1)} and ${truth(depth - 1)}"
        else -> "${truth(depth - 1)} OR ${truth(depth - 1)}"
    }

    fun number(depth: Int = DEEPEST): String = if (random.nextBoolean()) whole(depth) else decimal(depth)

    /** A list of at least three elements. */
    fun list(depth: Int = DEEPEST): String = known.oneOf(known.lists, random)?.takeIf { random.nextBoolean() }
        ?: List(random.nextInt(3, 6)) { whole(minOf(depth, 1)) }.toString()

    /** A number that is not a negative constant. */
    fun positive(): String = pick("0", "3", "1.5", "abs(${number(1)})")

    private fun divisor(depth: Int): String = pick("7", "-3", "70000", "(${whole(depth)} + length([1, 2]))")

    fun pick(vararg choices: String): String = choices[random.nextInt(choices.size)]

    private companion object {
        const val DEEPEST = 3

        /** The port of the colour sensor in the header of programs without bumpers. */
        const val COLOUR_PORT = 3
    }
}

/** The names of variables and routines in scope. */
class KnownNames {
    val wholes = mutableListOf<String>()
    val decimals = mutableListOf<String>()
    val truths = mutableListOf<String>()
    val lists = mutableListOf<String>()

    /** Functions that take and return a whole number. */
    val functions = mutableListOf<String>()

    /** Procedures that take a whole number and a condition. */
    val procedures = mutableListOf<String>()

    /** The assignable whole, decimal and truth variables. */
    val changing = mutableSetOf<String>()

    fun oneOf(names: List<String>, random: Random): String? = names.randomOrNull(random)

    /** Runs [write] in a scope of its own. */
    fun <T> inBlock(write: () -> T): T {
        val kinds = listOf(wholes, decimals, truths, lists)
        val sizes = kinds.map { it.size }
        return write().also { kinds.zip(sizes).forEach { (names, size) -> names.subList(size, names.size).clear() } }
    }
}
