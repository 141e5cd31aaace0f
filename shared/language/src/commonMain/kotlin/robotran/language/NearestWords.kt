package robotran.language

/**
 * Those of [candidates] that [typed] may have been meant to be, with at most [errors] typing errors: the ones with the
 * fewest errors, and of these the ones that begin with the most letters of [typed]. Capitals make no difference.
 * Several if none is more likely than the others, in the order of [candidates]. None is another one of a series.
 */
fun nearestWords(typed: String, candidates: Iterable<String>, errors: Int): List<String> {
    val lowercase = typed.lowercase()
    val near = candidates.distinct()
        .filter { it.length - typed.length in -errors..errors && !isOtherOfSeries(typed, it) }
        .map { candidateFor(lowercase, it) }
        .filter { it.errors <= errors }
    val best = near.minWithOrNull(compareBy({ it.errors }, { -it.sameLetters })) ?: return emptyList()
    return near.filter { it.errors == best.errors && it.sameLetters == best.sameLetters }.map { it.word }
}

private fun candidateFor(typed: String, word: String): Candidate {
    val lowercase = word.lowercase()
    return Candidate(word, editDistance(typed, lowercase), typed.commonPrefixWith(lowercase).length)
}

private class Candidate(val word: String, val errors: Int, val sameLetters: Int)
