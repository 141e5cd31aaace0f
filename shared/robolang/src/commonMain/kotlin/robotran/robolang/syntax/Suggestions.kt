package robotran.robolang.syntax

import robotran.language.editDistance

/**
 * The one of [candidates] that [word] is probably a slip of, null if none is near enough. The first one wins a draw.
 */
internal fun suggestion(word: String, candidates: List<String>): String? {
    if (word.length > RobolangLimits.SUGGESTION_CHARACTERS) return null
    val lowercase = lowercaseKeyword(word)
    val nearest = candidates.minByOrNull { editDistance(lowercase, it) } ?: return null
    return nearest.takeIf { editDistance(lowercase, it) <= forgivenDistance(lowercase) }
}

/** Short words look alike too easily: one slip in three letters, and one in any case from three letters on. */
private fun forgivenDistance(word: String): Int = word.length / LETTERS_FOR_A_SLIP

private const val LETTERS_FOR_A_SLIP = 3
