package robotran.learning.hint

/** One place where a program differs from the solution. */
internal sealed interface ProgramDifference {
    /** The line of the program that it concerns, from 1. */
    val line: Int

    /** [mine] stands where the solution has [meant], and has the same form. */
    class Changed(val mine: CodeLine, val meant: CodeLine) : ProgramDifference {
        override val line get() = mine.number

        /** The differing tokens, the program's first; [TokenPair.index] is their place in both lines. */
        val pairs: List<TokenPair> = mine.tokens.indices.mapNotNull { index ->
            TokenPair(index, mine.tokens[index], meant.tokens[index]).takeIf { it.mine != it.meant }
        }
    }

    /** The solution's line [meant] is missing after [line]; 0 if nothing stands before it. */
    class Missing(override val line: Int, val meant: CodeLine) : ProgramDifference

    /** The solution has nothing like [mine]. */
    class Extra(val mine: CodeLine) : ProgramDifference {
        override val line get() = mine.number
    }
}

internal class TokenPair(val index: Int, val mine: String, val meant: String)

/**
 * The differences between [program] and [solution] in the alignment with the fewest. Lines of the same form, which
 * differ only in numbers, directions, comparisons and the like, may stand for each other. Null if the programs have
 * less than half of their lines in common, so that a comparison says nothing.
 */
internal fun differences(program: List<CodeLine>, solution: List<CodeLine>): List<ProgramDifference>? {
    val costs = alignmentCosts(program, solution)
    val found = mutableListOf<ProgramDifference>()
    var common = 0
    var mine = 0
    var meant = 0
    while (mine < program.size || meant < solution.size) {
        val change = if (mine < program.size && meant < solution.size) cost(program[mine], solution[meant]) else null
        when {
            change != null && costs[mine][meant] == change + costs[mine + 1][meant + 1] -> {
                if (change > 0) found += ProgramDifference.Changed(program[mine], solution[meant])
                common++
                mine++
                meant++
            }

            meant < solution.size && costs[mine][meant] == GAP + costs[mine][meant + 1] -> {
                found += ProgramDifference.Missing(if (mine > 0) program[mine - 1].number else 0, solution[meant++])
            }

            else -> found += ProgramDifference.Extra(program[mine++])
        }
    }
    return found.takeIf { common * 2 >= maxOf(program.size, solution.size) }
}

/** The least cost of aligning the lines from a place on in either program. */
private fun alignmentCosts(program: List<CodeLine>, solution: List<CodeLine>): Array<IntArray> {
    val costs = Array(program.size + 1) { IntArray(solution.size + 1) }
    for (mine in program.size downTo 0) {
        for (meant in solution.size downTo 0) {
            if (mine == program.size && meant == solution.size) continue
            var least = Int.MAX_VALUE
            if (mine < program.size) least = GAP + costs[mine + 1][meant]
            if (meant < solution.size) least = minOf(least, GAP + costs[mine][meant + 1])
            if (mine < program.size && meant < solution.size) {
                cost(program[mine], solution[meant])?.let { least = minOf(least, it + costs[mine + 1][meant + 1]) }
            }
            costs[mine][meant] = least
        }
    }
    return costs
}

/** The cost of [mine] in the place of [meant]: 0 if equal; null if their forms differ. */
private fun cost(mine: CodeLine, meant: CodeLine): Int? = when {
    mine.tokens == meant.tokens -> 0
    mine.tokens.size != meant.tokens.size -> null
    mine.tokens.zip(meant.tokens).all { (a, b) -> formOf(a) == formOf(b) } -> CHANGE
    else -> null
}

private fun formOf(token: String): String = if (isNumber(token)) NUMBER else FORMS[token] ?: token

/** Tokens that pupils mistake for each other. */
private val FORMS: Map<String, String> = listOf(
    listOf("left", "right"),
    listOf("turnleft", "turnright"),
    listOf("forward", "backward"),
    listOf("up", "down"),
    listOf("<", "<=", ">", ">=", "==", "!="),
    listOf("a", "b", "c"),
    listOf("s1", "s2", "s3"),
    listOf("second", "seconds", "millisecond", "milliseconds"),
    listOf("and", "or"),
    listOf("+", "-", "*", "/", "mod"),
    listOf("if", "while"),
    listOf("until", "while"),
    listOf("true", "false"),
    listOf("light", "timer", "battery"),
).flatMap { group -> group.map { it to group.first() } }.toMap()

private const val NUMBER = "#"
private const val CHANGE = 2
private const val GAP = 3
