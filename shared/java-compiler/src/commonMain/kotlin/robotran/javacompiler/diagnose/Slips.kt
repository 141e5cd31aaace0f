package robotran.javacompiler.diagnose

/** Longer names get no suggestion, and only so many are compared, so that it costs next to nothing. */
private const val LONGEST_NAME = 40
private const val COMPARED_NAMES = 600

/** Short names look alike too easily: one slip in three letters. */
private const val LETTERS_FOR_A_SLIP = 3

/** The one of [candidates] that [name] is a slip of, with at most [forgiven] slips; null if none is near enough. The first one wins a draw. */
internal fun nearest(name: String, candidates: Collection<String>, forgiven: Int = name.length / LETTERS_FOR_A_SLIP): String? {
    if (name.length > LONGEST_NAME) return null
    val others = candidates.asSequence().filter { it != name && it.length <= LONGEST_NAME }.take(COMPARED_NAMES)
    val lowercase = name.lowercase()
    return others.map { it to slips(lowercase, it.lowercase()) }.minByOrNull { it.second }
        ?.takeIf { (_, slips) -> slips <= forgiven }?.first
}

/**
 * How many letters are too many, too few, wrong or have changed places with their neighbour. Robolang measures slips
 * in the same way; the two languages share nothing else, and a module of their own for these lines would tie one to the other.
 */
private fun slips(typed: String, meant: String): Int {
    val distance = Array(typed.length + 1) { row -> IntArray(meant.length + 1) { column -> if (row == 0) column else row } }
    for (row in 1..typed.length) {
        for (column in 1..meant.length) {
            val wrong = if (typed[row - 1] == meant[column - 1]) 0 else 1
            val fewest = minOf(distance[row - 1][column] + 1, distance[row][column - 1] + 1, distance[row - 1][column - 1] + wrong)
            val swapped = row > 1 && column > 1 && typed[row - 1] == meant[column - 2] && typed[row - 2] == meant[column - 1]
            distance[row][column] = if (swapped) minOf(fewest, distance[row - 2][column - 2] + 1) else fewest
        }
    }
    return distance[typed.length][meant.length]
}
