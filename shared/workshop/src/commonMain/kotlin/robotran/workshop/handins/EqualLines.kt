package robotran.workshop.handins

/**
 * For each line of [lines], whether [others] has the same one in the same order, apart from blanks. Lines without
 * letters or digits, such as a brace, count only beside one that counts.
 */
fun equalLines(lines: List<String>, others: List<String>): List<Boolean> {
    val own = lines.take(MAX_LINES).map(::essence)
    val other = others.take(MAX_LINES).map(::essence)
    // The length of the longest common subsequence of what follows both places.
    val common = Array(own.size + 1) { IntArray(other.size + 1) }
    for (i in own.indices.reversed()) {
        for (j in other.indices.reversed()) {
            common[i][j] =
                if (own[i] == other[j]) common[i + 1][j + 1] + 1 else maxOf(common[i + 1][j], common[i][j + 1])
        }
    }
    val equal = BooleanArray(lines.size)
    var i = 0
    var j = 0
    while (i < own.size && j < other.size) {
        when {
            own[i] == other[j] -> {
                equal[i] = own[i].isNotEmpty()
                i++
                j++
            }

            common[i + 1][j] >= common[i][j + 1] -> i++
            else -> j++
        }
    }
    return lines.indices.map { place ->
        equal[place] &&
            (isTelling(lines[place]) || equal.getOrElse(place - 1) { false } || equal.getOrElse(place + 1) { false })
    }
}

private fun essence(line: String): String = line.trim().replace(BLANKS, " ")

private fun isTelling(line: String): Boolean = line.any { it.isLetterOrDigit() }

private val BLANKS = Regex("\\s+")

/** Longer programs are compared up to here, since it takes the square of that. */
private const val MAX_LINES = 1_000
