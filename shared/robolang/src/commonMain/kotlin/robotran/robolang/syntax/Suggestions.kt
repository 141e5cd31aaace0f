package robotran.robolang.syntax

import robotran.language.editDistance

/** The candidate that [word] is probably a misspelling of; null if none is similar. The first one wins a tie. */
internal fun suggestion(word: String, candidates: List<String>): String? {
    if (word.length > RobolangLimits.SUGGESTION_CHARACTERS) return null
    val lowercase = lowercaseKeyword(word)
    val nearest = candidates.minByOrNull { editDistance(lowercase, it) } ?: return null
    return nearest.takeIf { editDistance(lowercase, it) <= forgivenDistance(lowercase) }
}

/** The max edit distance: one per three letters, since short words are often similar by chance. */
private fun forgivenDistance(word: String): Int = word.length / LETTERS_FOR_A_SLIP

private const val LETTERS_FOR_A_SLIP = 3
