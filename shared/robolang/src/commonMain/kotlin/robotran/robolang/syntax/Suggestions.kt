package robotran.robolang.syntax

/** The one of [candidates] that [word] is probably a slip of, null if none is near enough. The first one wins a draw. */
internal fun suggestion(word: String, candidates: List<String>): String? {
    if (word.length > RobolangLimits.SUGGESTION_CHARACTERS) return null
    val lowercase = lowercaseKeyword(word)
    val nearest = candidates.minByOrNull { slips(lowercase, it) } ?: return null
    return nearest.takeIf { slips(lowercase, it) <= forgivenSlips(lowercase) }
}

/** Short words look alike too easily: one slip in three letters, and one in any case from three letters on. */
private fun forgivenSlips(word: String): Int = word.length / LETTERS_FOR_A_SLIP

private const val LETTERS_FOR_A_SLIP = 3

/**
 * How many slips of a finger lie between two words: a letter too many, too few, a wrong one, or two that changed places
 * (the optimal string alignment distance).
 */
internal fun slips(typed: String, meant: String): Int {
    var beforeLast = IntArray(meant.length + 1)
    var last = IntArray(meant.length + 1) { it }
    for (row in 1..typed.length) {
        val current = IntArray(meant.length + 1)
        current[0] = row
        for (column in 1..meant.length) {
            val wrong = if (typed[row - 1] == meant[column - 1]) 0 else 1
            var fewest = minOf(last[column] + 1, current[column - 1] + 1, last[column - 1] + wrong)
            val swapped = row > 1 && column > 1 &&
                typed[row - 1] == meant[column - 2] && typed[row - 2] == meant[column - 1]
            if (swapped) fewest = minOf(fewest, beforeLast[column - 2] + 1)
            current[column] = fewest
        }
        beforeLast = last
        last = current
    }
    return last[meant.length]
}
