package robotran.nqc.syntax

import robotran.language.nearestWords
import robotran.nqc.config.NqcLimits

/** The one of [candidates] that [typed] was probably meant to be: the same but for case, or for a few letters. */
internal fun similarName(typed: String, candidates: Iterable<String>): String? =
    similarNames(typed, candidates).firstOrNull()

/** The same for a fix: null if others are as similar. */
internal fun onlySimilarName(typed: String, candidates: Iterable<String>): String? =
    similarNames(typed, candidates).singleOrNull()

private fun similarNames(typed: String, candidates: Iterable<String>): List<String> {
    if (typed.length !in 2..NqcLimits.SUGGESTION_CHARACTERS) return emptyList()
    val errors = (typed.length / LETTERS_PER_ERROR).coerceIn(1, MOST_ERRORS)
    return nearestWords(typed, candidates.filterNot { it.startsWith("_") }, errors)
}

private const val LETTERS_PER_ERROR = 4
private const val MOST_ERRORS = 3
