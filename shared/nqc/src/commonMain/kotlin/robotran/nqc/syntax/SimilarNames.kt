package robotran.nqc.syntax

import robotran.language.editDistance
import robotran.nqc.config.NqcLimits

/** The one of [candidates] that [typed] was probably meant to be: the same but for case, or for a few letters. */
internal fun similarName(typed: String, candidates: Iterable<String>): String? {
    if (typed.length > NqcLimits.SUGGESTION_CHARACTERS) return null
    val longest = typed.length / LETTERS_PER_ERROR + 1
    return candidates.distinct()
        .filter { it.length - typed.length in -longest..longest && !it.startsWith("_") }
        .map { it to if (it.equals(typed, ignoreCase = true)) 0 else editDistance(typed.lowercase(), it.lowercase()) }
        .filter { (_, distance) -> distance <= (typed.length / LETTERS_PER_ERROR).coerceIn(1, MOST_ERRORS) }
        .minByOrNull { (_, distance) -> distance }
        ?.takeIf { typed.length > 1 }
        ?.first
}

private const val LETTERS_PER_ERROR = 4
private const val MOST_ERRORS = 3
