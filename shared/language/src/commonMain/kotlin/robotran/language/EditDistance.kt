package robotran.language

/**
 * The number of typing errors between two words: an extra, missing or wrong letter, or two neighbours swapped. This is
 * the optimal string alignment variant of the Damerau-Levenshtein distance.
 */
fun editDistance(typed: String, intended: String): Int {
    var beforeLast = IntArray(intended.length + 1)
    var last = IntArray(intended.length + 1) { it }
    for (row in 1..typed.length) {
        val current = IntArray(intended.length + 1)
        current[0] = row
        for (column in 1..intended.length) {
            val wrong = if (typed[row - 1] == intended[column - 1]) 0 else 1
            var fewest = minOf(last[column] + 1, current[column - 1] + 1, last[column - 1] + wrong)
            val swapped = row > 1 && column > 1 &&
                typed[row - 1] == intended[column - 2] && typed[row - 2] == intended[column - 1]
            if (swapped) fewest = minOf(fewest, beforeLast[column - 2] + 1)
            current[column] = fewest
        }
        beforeLast = last
        last = current
    }
    return last[intended.length]
}
